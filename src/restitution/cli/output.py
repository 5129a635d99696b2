"""Where results go, how far the work has come, and what Ctrl-C does."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from enum import StrEnum
from pathlib import Path
from typing import Any, TextIO

from restitution.cli.files import say, shown_name
from restitution.cli.statuses import INTERRUPTED, UNANSWERED
from restitution.records import dataclass


class RefusedError(Exception):
    """Options that cannot be used as they are: why, and which of them; nothing was done yet."""

    def __init__(self, message: str, option: str) -> None:
        super().__init__(message)
        self.message = message
        self.option = option


class Format(StrEnum):
    """How a solution is written down."""

    text = "text"
    markdown = "markdown"
    latex = "latex"
    html = "html"
    json = "json"


class Marks(StrEnum):
    """Whose habits the marks of a working follow; none are left out."""

    fm1 = "fm1"
    m4 = "m4"
    caie = "caie"
    none = "none"


class MarkingFormat(StrEnum):
    """How a marking is written down."""

    text = "text"
    json = "json"
    html = "html"


class Stage(StrEnum):
    """A stage of a statement on its way to its answers."""

    tree = "tree"
    equations = "equations"
    derivation = "derivation"


class PictureFormat(StrEnum):
    """What a picture is stored as."""

    svg = "svg"
    png = "png"
    pdf = "pdf"


class SheetFormat(StrEnum):
    """What a sheet is stored as."""

    pdf = "pdf"
    html = "html"


_ENDINGS = {
    Format.text: ".txt",
    Format.markdown: ".md",
    Format.latex: ".tex",
    Format.html: ".html",
    Format.json: ".json",
}


@dataclass
class Target:
    """Standard output, a file, or a folder with a file for each; opened when there is a text."""

    format: Format
    path: Path | None = None
    folder: bool = False
    stream: TextIO | None = None

    @property
    def to_terminal(self) -> bool:
        return self.path is None and sys.stdout.isatty()

    def write(self, file: str, text: str, *, several: bool) -> None:
        """Adds what is said of one file. Exits with a message where that cannot be written."""
        if not text:
            return
        if several and not self.folder and self.format in (Format.text, Format.markdown):
            text = (
                f"{'=' * 3} {shown_name(file)} {'=' * 3}\n\n{text}\n"
                if (self.format is Format.text)
                else f"<!-- {shown_name(file)} -->\n\n{text}\n"
            )
        try:
            if self.path is None:
                put(text)
            elif self.folder:
                self.path.mkdir(parents=True, exist_ok=True)
                _in_folder(self.path, file, self.format).write_text(text, encoding="utf-8")
            else:
                if self.stream is None:
                    self.stream = self.path.open("w", encoding="utf-8")
                self.stream.write(text)
                self.stream.flush()
        except OSError as error:
            if self.path is None:
                raise  # told where the command ends
            if self.stream is not None:
                with suppress(OSError):  # it has been told already
                    self.stream.close()
                self.stream = None
            say(f"{error.filename or self.path}: cannot be written: {error.strerror}")
            raise SystemExit(UNANSWERED) from None

    @contextmanager
    def written(self) -> Iterator[None]:
        try:
            yield
        finally:
            if self.stream is not None:
                self.stream.close()


def put(text: str) -> None:
    """To standard output, in UTF-8 unless it is a terminal, which knows its own encoding."""
    if not sys.stdout.isatty() and hasattr(sys.stdout, "buffer"):
        sys.stdout.flush()
        sys.stdout.buffer.write(text.encode("utf-8", errors="replace"))
        sys.stdout.buffer.flush()
    else:
        sys.stdout.write(text)
        sys.stdout.flush()


def target_of(output: str | None, files: list[str], form: Format) -> Target:
    """Where the solutions go. Raises RefusedError for what would be lost or unusable."""
    if output is None or output == "-":
        target = Target(form)
    else:
        folder = output.endswith(("/", os.sep)) or Path(output).is_dir()
        target = Target(form, Path(output), folder)
    if not target.folder and len(files) > 1 and form in (Format.html, Format.latex):
        raise RefusedError(
            f"several files as {form.value} need a folder: --output FOLDER/", "--output"
        )
    if target.path is not None:
        named = [_in_folder(target.path, file, form) for file in files] if target.folder else []
        for path in named or [target.path]:
            if named.count(path) > 1:
                raise RefusedError(f"{path} would be written more than once", "--output")
            if any(_same_file(path, file) for file in files):
                raise RefusedError(
                    f"{path} is one of the statements: it would be overwritten", "--output"
                )
    return target


def write_file(output: str, content: bytes, statements: list[str]) -> None:
    """One result to a file, or to standard output. Exits with a message where it cannot be."""
    if output == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(content)
        sys.stdout.buffer.flush()
        return
    path = Path(output)
    if any(_same_file(path, statement) for statement in statements):
        raise RefusedError(f"{path} is one of the statements: it would be overwritten", "--output")
    try:
        path.write_bytes(content)
    except OSError as error:
        say(f"{error.filename or path}: cannot be written: {error.strerror}")
        raise SystemExit(UNANSWERED) from None


def _in_folder(folder: Path, file: str, form: Format) -> Path:
    stem = "standard-input" if file == "-" else Path(file).name.removesuffix(".impact")
    return folder / (stem + _ENDINGS[form])


def _same_file(path: Path, file: str) -> bool:
    try:
        return path.samefile(file)
    except (OSError, ValueError):
        return False


_Progressing = Callable[[Iterable[str]], Iterator[str]]


@contextmanager
def silent(to_terminal: bool) -> Iterator[_Progressing]:
    """No progress to be seen."""
    yield iter


def progress(files: list[str]) -> Any:
    """How far it has come, on standard error, if somebody is looking there."""

    @contextmanager
    def shown(to_terminal: bool) -> Iterator[_Progressing]:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

        # Drawn by hand and not by a thread, so that a process can be forked at any time.
        progress = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            console=Console(stderr=True),
            auto_refresh=False,
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        task = progress.add_task("", total=len(files))

        def progressing(names: Iterable[str]) -> Iterator[str]:
            for name in names:
                progress.update(task, description=Path(shown_name(name)).name)
                progress.start()
                progress.refresh()
                try:
                    yield name
                finally:
                    progress.stop()
                progress.advance(task)

        yield progressing

    return shown if sys.stderr.isatty() else silent


@contextmanager
def nothing() -> Iterator[None]:
    """No context."""
    yield


@contextmanager
def interruptible() -> Iterator[None]:
    """Ctrl-C ends the command with one word."""
    try:
        yield
    except KeyboardInterrupt:
        say("interrupted")
        raise SystemExit(INTERRUPTED) from None
