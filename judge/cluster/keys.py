"""Certificates: who holds a copy of the folder may reach the cluster, and nobody else.

    ca.pem     the authority that has signed the certificate; its own key is thrown away when it is made
    cert.pem   the certificate that every side shows to the other
    key.pem    the certificate's key, the secret of the three

Both sides ask for a certificate of this authority. One folder serves a whole cluster: who reaches it can run
programs on every machine of it anyway.
"""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from msgspec import Struct

from judge.atomic import new_file
from judge.cluster.need import distributed, x509
from judge.errors import UsageError, unwritable
from judge.folders import user_data
from judge.reading import read_ordinary

VARIABLE = "JUDGE_KEYS"
FILES = ("ca.pem", "cert.pem", "key.pem")
_DAYS = 3 * 365
_MAKE = "make them with 'judge worker --new-keys DIR'"


class Keys(Struct, frozen=True):
    """The three files of a folder, by their names in `FILES`: text in PEM."""

    ca: str
    cert: str
    key: str

    def security(self) -> Any:
        """What dask.distributed wants to know: TLS both ways, and nothing without it."""
        distributed()
        from distributed.security import Security

        roles = {
            f"tls_{role}_{part}": text
            for role in ("client", "scheduler", "worker")
            for part, text in (("cert", self.cert), ("key", self.key))
        }
        make: Any = Security
        return make(require_encryption=True, tls_ca_file=self.ca, **roles)

    def text(self) -> str:
        """All three in one text, as `of_lines` reads them."""
        return self.ca + self.cert + self.key

    def write(self, folder: Path) -> None:
        """Write the three files, for their owner alone. Raises UsageError, also where one is there."""
        try:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            there = [name for name in FILES if os.path.lexists(folder / name)]
            if there:
                remedy = "name another folder, or take the old keys away where no machine uses them"
                raise UsageError(f"{there[0]} is there already", where=str(folder), remedy=remedy)
            for name, content in zip(FILES, (self.ca, self.cert, self.key), strict=True):
                new_file(folder / name, content.encode())
                (folder / name).chmod(0o600)
        except OSError as fault:
            raise unwritable(folder, fault, "name another folder") from fault


def new_keys() -> Keys:
    """An authority of its own, and a certificate that it has signed for three years."""
    x509()
    from cryptography import x509 as pem
    from cryptography.hazmat.primitives import hashes, serialization
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.x509.oid import NameOID

    def named(text: str) -> Any:
        return pem.Name([pem.NameAttribute(NameOID.COMMON_NAME, text)])

    now = datetime.now(UTC)
    authority, own = ec.generate_private_key(ec.SECP256R1()), ec.generate_private_key(ec.SECP256R1())

    def signed(subject: str, key: Any, *, is_authority: bool) -> str:
        builder = (
            pem.CertificateBuilder()
            .subject_name(named(subject))
            .issuer_name(named("judge authority"))
            .public_key(key.public_key())
            .serial_number(pem.random_serial_number())
            .not_valid_before(now - timedelta(days=1))  # clocks of a lab differ
            .not_valid_after(now + timedelta(days=_DAYS))
            .add_extension(pem.BasicConstraints(ca=is_authority, path_length=None), critical=True)
        )
        made = builder.sign(authority, hashes.SHA256())
        return made.public_bytes(serialization.Encoding.PEM).decode()

    secret = own.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    return Keys(
        ca=signed("judge authority", authority, is_authority=True),
        cert=signed("judge", own, is_authority=False),
        key=secret.decode(),
    )


def default_folder() -> Path:
    """Where keys are looked for that no option names: $JUDGE_KEYS, or a folder among the person's data."""
    own = os.environ.get(VARIABLE)
    return Path(own) if own else user_data() / "keys"


def read_keys(folder: Path | None) -> Keys:
    """The keys in `folder`, or in the default one. Raises UsageError, also for a key that is no secret."""
    place = default_folder() if folder is None else folder
    found = []
    for name in FILES:
        path = place / name
        try:
            if name == "key.pem":
                _check_secret(path)
            found.append(read_ordinary(path).decode("ascii"))
        except OSError as fault:
            reason = (fault.strerror or "it failed").lower()
            where = "--keys DIR or $JUDGE_KEYS names another folder"
            raise UsageError(
                f"cannot be read ({reason})", where=str(path), remedy=f"{_MAKE}; {where}"
            ) from fault
        except UnicodeDecodeError as fault:
            raise UsageError("is no PEM file", where=str(path), remedy=_MAKE) from fault
    keys = Keys(*found)
    _check_match(keys, place)
    return keys


def of_lines(lines: Iterator[bytes]) -> Keys:
    """The keys of `Keys.text`, of which no more lines are read than they have. Raises UsageError."""
    blocks, block = [], ""
    for content in lines:
        block += content.decode("ascii", "replace").replace("\r", "")
        if block.count("-----END ") and block.endswith("-----\n"):
            blocks.append(block)
            block = ""
        if len(blocks) == len(FILES):
            break
    else:
        what = "there are no keys on standard input"
        raise UsageError(what, remedy=f"give {', '.join(FILES)}, one after the other")
    keys = Keys(*blocks)
    _check_match(keys, Path("standard input"))
    return keys


def _check_secret(path: Path) -> None:
    """Refuse a key that others of this machine may read."""
    mode = path.stat().st_mode
    if mode & (stat.S_IRWXG | stat.S_IRWXO):
        raise UsageError("others may read this key", where=str(path), remedy=f"chmod 600 '{path}'")


def _check_match(keys: Keys, place: Path) -> None:
    """Refuse three texts that do not belong together, or that are no keys at all."""
    import ssl

    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    try:
        context.load_verify_locations(cadata=keys.ca)
        with tempfile.TemporaryDirectory() as folder:  # ssl reads a certificate's key from files only
            files = [Path(folder, name) for name in ("cert", "key")]
            for path, text in zip(files, (keys.cert, keys.key), strict=True):
                path.touch(0o600)
                path.write_text(text)
            context.load_cert_chain(files[0], files[1], password="")
    except (ssl.SSLError, ValueError) as fault:
        what = "the three files are no keys that belong together"
        raise UsageError(what, where=str(place), remedy=f"copy all three anew, or {_MAKE}") from fault
