"""All files of a package, as paths and bytes; nothing is written here."""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from pprint import pformat

from msgspec import Struct

from judge.packs.export.cases import Test
from judge.packs.export.forms import answer_form, parameter_form
from judge.packs.export.metadata import Version, domjudge_ini, problem_yaml
from judge.packs.export.programs import Programs
from judge.problem import Problem

Files = Mapping[str, bytes]  # by path within the package, parts separated by /

_VALIDATORS = Path(__file__).parent / "validators"
_NO_PARAMETERS = "PARAMETERS = []"
_BUILD = b"#!/bin/sh\nchmod +x run\n"
_RUN = b'#!/bin/sh\nexec python3 "$(dirname "$0")/validate.py" "$@"\n'
_SCRIPTS = ("build", "run")
_DATE = (1980, 1, 1, 0, 0, 0)  # the same bytes for the same package


class Contents(Struct, frozen=True):
    """What a package is made of, whatever its version."""

    problem: Problem
    tests: Sequence[Test]
    programs: Programs
    statement: str

    def files(self, version: Version) -> Files:
        """The files of the package in that version."""
        is_legacy = version is Version.LEGACY
        found = {"problem.yaml": problem_yaml(self.problem, version, self.programs.seconds).encode()}
        folder = "problem_statement" if is_legacy else "statement"
        found[f"{folder}/problem.en.tex"] = self.statement.encode()
        found["input_validators/validate.py"] = self._input_validator()
        folder = "output_validators/exact" if is_legacy else "output_validator"
        found |= {f"{folder}/{name}": content for name, content in self._output_validator().items()}
        found |= {f"submissions/{each.path}": each.source for each in self.programs.held}
        for test in self.tests:
            place = f"data/{test.folder}/{test.stem}"
            found |= {f"{place}.in": test.input, f"{place}.ans": test.answer}
            if is_legacy:
                found[f"{place}.desc"] = f"{test.group.group.about}\n".encode()
            else:
                about = json.dumps(test.group.group.about, ensure_ascii=False)
                found[f"{place}.yaml"] = f"description: {about}\n".encode()
        if (
            not is_legacy
        ):  # or bt tries the answers in other case and spacing, and warns of each that is refused
            arguments = "output_validator_args: [case_sensitive, space_change_sensitive]\n"
            found["data/test_group.yaml"] = arguments.encode()
        return found

    def domjudge(self) -> Files:
        """The files of the archive that DOMjudge imports: those of the legacy version, and its own.

        A validator of several files needs a script there that builds it, and one that runs it.
        """
        found = dict(self.files(Version.LEGACY))
        found["domjudge-problem.ini"] = domjudge_ini(self.problem, self.programs.seconds).encode()
        return found | {
            "output_validators/exact/build": _BUILD,
            "output_validators/exact/run": _RUN,
        }

    def _input_validator(self) -> bytes:
        source = (_VALIDATORS / "input_validator.py").read_text(encoding="utf-8")
        forms = [parameter_form(parameter) for parameter in self.problem.parameters]
        table = pformat(forms, width=100, compact=True)
        assert source.count(_NO_PARAMETERS) == 1
        return source.replace(_NO_PARAMETERS, f"PARAMETERS = {table}").encode()

    def _output_validator(self) -> Files:
        return {
            "validate.py": (_VALIDATORS / "output_validator.py").read_bytes(),
            "accepted.json": self._accepted(),
        }

    def _accepted(self) -> bytes:
        """The table of what is accepted, a line for each input."""
        head = json.dumps({"problem": self.problem.id, "answer": answer_form(self.problem.answer)})
        rows = [f'"{test.key}": {json.dumps(test.accepted, separators=(",", ":"))}' for test in self.tests]
        return f'{head[:-1]}, "files": {{\n{f",{chr(10)}".join(rows)}\n}}}}\n'.encode()


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


def digest(files: Files) -> str:
    """A hash of all paths and contents, in hex."""
    plain = hashlib.sha256()
    for path in sorted(files):
        plain.update(f"{path}\0{len(files[path])}\0".encode() + files[path])
    return plain.hexdigest()
