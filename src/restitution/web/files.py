"""Files and pages as they are sent: read once, packed once, and named by what they hold."""

from __future__ import annotations

import gzip
import hashlib
import re
from collections.abc import Mapping
from pathlib import Path
from posixpath import dirname, join, normpath

from starlette.requests import Request
from starlette.responses import Response

from restitution.records import dataclass

_KINDS = {
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
    ".woff2": "font/woff2",
}
"""What is served, by the ending of its name. Whatever else lies in a folder is not."""

_IMPORT = re.compile(r'^import [^"]*"(\.[^"]+)";', re.MULTILINE)


@dataclass(frozen=True)
class Stored:
    """The content of one address; ``packed`` is the same by gzip, where that is smaller."""

    content: bytes
    packed: bytes | None
    kind: str
    tag: str

    def reply(self, request: Request, kept: str, status: int = 200) -> Response:
        """The response to a request; ``kept`` is for how long a browser may keep it."""
        headers = {"Cache-Control": kept, "ETag": self.tag, "Vary": "Accept-Encoding"}
        if status == 200 and self.tag in request.headers.get("if-none-match", ""):
            return Response(status_code=304, headers=headers)
        if self.packed is not None and unpacks(request):
            headers["Content-Encoding"] = "gzip"
            return Response(self.packed, status, headers, self.kind)
        return Response(self.content, status, headers, self.kind)


def unpacks(request: Request) -> bool:
    """Whether the one who asks can undo gzip."""
    return "gzip" in request.headers.get("accept-encoding", "")


def stored(content: bytes, kind: str) -> Stored:
    """Something to be sent. Its tag is a weak one: packed or not, it says the same."""
    packed = None if kind.startswith("font/") else gzip.compress(content, mtime=0)
    smaller = packed if packed is not None and len(packed) < len(content) else None
    return Stored(content, smaller, kind, f'W/"{hashlib.sha256(content).hexdigest()[:16]}"')


def files_of(folders: Mapping[str, Path]) -> dict[str, Stored]:
    """The files below some folders, by their path, that of a folder before it."""
    return {
        f"{name}/{path.relative_to(folder).as_posix()}".lstrip("/"): stored(
            path.read_bytes(), _KINDS[path.suffix]
        )
        for name, folder in folders.items()
        for path in sorted(folder.rglob("*"))
        if path.suffix in _KINDS
    }


def imported(files: Mapping[str, Stored], path: str) -> list[str]:
    """The modules that a module needs from its start, itself among them, each once."""
    paths = [path]
    for module in paths:  # which grows meanwhile
        for name in _IMPORT.findall(files[module].content.decode()):
            needed = normpath(join(dirname(module), name))
            if needed not in paths:
                paths.append(needed)
    return paths


def digest(files: Mapping[str, Stored]) -> str:
    """A name for just these files: what it names can be kept for ever."""
    seen = hashlib.sha256()
    for path, file in files.items():
        seen.update(f"{path} {file.tag}\n".encode())
    return seen.hexdigest()[:12]
