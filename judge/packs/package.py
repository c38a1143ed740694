"""All files of a package, as paths and bytes; nothing is written here."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from pprint import pformat
from typing import Any

from msgspec import Struct

from judge.packs.cases import Test
from judge.packs.metadata import Version, domjudge_ini, problem_yaml
from judge.packs.programs import Programs
from judge.packs.schemas import form_of, whole_output
from judge.problem import Problem

Files = Mapping[str, bytes]  # by path within the package, parts separated by /

_VALIDATORS = Path(__file__).parent / "validators"
_NO_PARAMETERS, _NO_INPUTS = "PARAMETERS = []", "INPUTS = []"
_BUILD = b"#!/bin/sh\nchmod +x run\n"
_RUN = b'#!/bin/sh\nexec python3 "$(dirname "$0")/validate.py" "$@"\n'
_SCRIPTS = ("build", "run")
_DATE = (1980, 1, 1, 0, 0, 0)  # the same bytes for the same package


class Contents(Struct, frozen=True):
    """What a package is made of, whatever its version; `brought` is the problem.py that it takes along."""

    problem: Problem
    tests: Sequence[Test]
    programs: Programs
    statement: str
    brought: bytes = b""

    def files(self, version: Version) -> Files:
        """The files of the package in that version."""
        statement, validator, ending = "statement", "output_validator", "yaml"
        if version is Version.LEGACY:
            statement, validator, ending = "problem_statement", "output_validators/exact", "desc"
        found = {
            "problem.yaml": problem_yaml(self.problem, version, self.programs.seconds).encode(),
            f"{statement}/problem.en.tex": self.statement.encode(),
            "input_validators/validate.py": self._input_validator(),
            f"{validator}/validate.py": (_VALIDATORS / "output_validator.py").read_bytes(),
            f"{validator}/accepted.json": self._accepted(),
            **{f"submissions/{file}": source for file, source in self.programs.sources.items()},
        }
        if self.brought:  # and what it imports; of several files the tools start the first one by name
            declared = (_VALIDATORS / "declare.py").read_bytes()
            found |= {f"{validator}/validate_declare.py": declared}
            found |= {f"{validator}/validate_problem.py": self.brought}
        if self.problem.talks:
            found |= {f"{validator}/validate_talk.py": (_VALIDATORS / "talk.py").read_bytes()}
        for test in self.tests:
            place, about = f"data/{test.folder}/{test.stem}", test.group.group.about
            if version is not Version.LEGACY:
                about = f"description: {json.dumps(about, ensure_ascii=False)}"
            found |= {f"{place}.in": test.input, f"{place}.ans": test.answer}
            found[f"{place}.{ending}"] = f"{about}\n".encode()
        if version is not Version.LEGACY:
            # or bt tries the answers in other case and spacing, and warns of each that is refused
            arguments = b"output_validator_args: [case_sensitive, space_change_sensitive]\n"
            found["data/test_group.yaml"] = arguments
        return found

    def domjudge(self) -> Files:
        """The files of the archive that DOMjudge imports: those of the legacy version, and its own.

        A validator of several files needs a script there that builds it, and one that runs it.
        """
        return {
            **self.files(Version.LEGACY),
            "domjudge-problem.ini": domjudge_ini(self.problem, self.programs.seconds).encode(),
            "output_validators/exact/build": _BUILD,
            "output_validators/exact/run": _RUN,
        }

    def _input_validator(self) -> bytes:
        source = (_VALIDATORS / "input_validator.py").read_text(encoding="utf-8")
        assert source.count(_NO_PARAMETERS) == source.count(_NO_INPUTS) == 1
        if self.problem.formatted and not self.problem.talks:
            known = pformat([test.key for test in self.tests])
            return source.replace(_NO_INPUTS, f"INPUTS = {known}").encode()
        forms = [form_of(parameter.type, parameter) for parameter in self.problem.parameters]
        table = pformat(forms, width=100, compact=True)
        return source.replace(_NO_PARAMETERS, f"PARAMETERS = {table}").encode()

    def _accepted(self) -> bytes:
        """The table of what is accepted, a line for each input, by its SHA-256."""
        told: dict[str, Any] = {"problem": self.problem.id}
        if not self.problem.talks:
            told["answer"] = form_of(self.problem.answer)
        if how := whole_output(self.problem):
            told["whole"] = how
        rows = ",\n".join(
            f'"{test.key}": {json.dumps(test.accepted, separators=(",", ":"))}' for test in self.tests
        )
        return f'{json.dumps(told)[:-1]}, "files": {{\n{rows}\n}}}}\n'.encode()


def zipped(files: Files, within: str = "") -> bytes:
    """An archive of the files; `within` is the folder that they are in."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(files):
            entry = zipfile.ZipInfo(f"{within}/{path}" if within else path, _DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            mode = 0o755 if path.rpartition("/")[2] in _SCRIPTS else 0o644
            entry.external_attr = (0o100000 | mode) << 16
            archive.writestr(entry, files[path])
    return buffer.getvalue()
