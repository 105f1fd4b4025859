#!/usr/bin/env python3
"""Do the tests notice single mistakes? Each *.mutant here is one; a test must fail with it.

A mutant is a text file:

    mistake: what is wrong, in one line
    file: server/trace/media.h
    test: unit_trace Media.*
    expected: survives, because ...       (only where no test can or should notice)
    --- old
    text that occurs exactly once in the file
    --- new
    text that takes its place

`test` names a test program and a GoogleTest filter: the nearest tests, not all that might notice.
Everything happens in a copy: a git worktree of what is committed or changed (not of untracked
files), with its own build folder. ccache makes second runs quick.
"""

import argparse
import collections
import fcntl
import fnmatch
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
KINDS = ("caught", "survived", "explained", "stale", "does not build")

Mutant = collections.namedtuple("Mutant", "name mistake file test filter expected old new")


class MutantError(Exception):
    pass


def read_mutant(path):
    name = str(path.relative_to(HERE).with_suffix(""))
    parts = re.split(r"^--- (old|new)\n", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    if len(parts) != 5 or parts[1] != "old" or parts[3] != "new":
        raise MutantError(f"{name}: needs one '--- old' and one '--- new' after it")
    fields = {}
    for line in parts[0].splitlines():
        key, colon, value = line.partition(":")
        if not colon or key not in ("mistake", "file", "test", "expected"):
            raise MutantError(f"{name}: cannot read the line '{line}'")
        fields[key] = value.strip()
    test = fields.get("test", "").split()
    if len(test) != 2 or not fields.get("mistake") or not fields.get("file"):
        raise MutantError(f"{name}: needs 'mistake', 'file' and 'test: PROGRAM FILTER'")
    expected = fields.get("expected", "")
    if expected and not re.match(r"survives\b.{10}", expected):
        raise MutantError(f"{name}: 'expected' must be 'survives' and a reason")
    # The last line break belongs to the format, so that a piece of a line can be changed too.
    old, new = (re.sub(r"\n\Z", "", part) for part in (parts[2], parts[4]))
    return Mutant(name, fields["mistake"], fields["file"], *test, expected, old, new)


def read_mutants(patterns):
    mutants = [read_mutant(path) for path in HERE.rglob("*.mutant")]
    for pattern in patterns:
        if not any(fnmatch.fnmatch(m.name, pattern) for m in mutants):
            raise MutantError(f"no mutant is called '{pattern}'")
    if patterns:
        mutants = [m for m in mutants if any(fnmatch.fnmatch(m.name, p) for p in patterns)]
    # Neighbours share a program, so that little has to be built in between.
    return sorted(mutants, key=lambda m: (m.test, m.file, m.name))


def mutated(source, mutant):
    """The file's text with the mistake in it; nothing if the mutant is stale."""
    path = source / mutant.file
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    if text.count(mutant.old) != 1 or mutant.old == mutant.new:
        return None
    return text.replace(mutant.old, mutant.new)


def call(*command, **options):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, errors="replace", check=False,
                          **options)


def must(*command, **options):
    done = call(*command, **options)
    if done.returncode != 0:
        raise MutantError(f"{' '.join(map(str, command))}:\n{done.stdout[-4000:]}")
    return done.stdout.strip()


class Copy:
    """The scratch copy: a worktree and its build folder."""

    def __init__(self, folder, jobs, limit):
        self.folder, self.jobs, self.limit = folder, jobs, limit
        self.source, self.build_folder = folder / "source", folder / "source" / "build"
        # Paths relative to the copy: what another folder's build has compiled is found by ccache.
        self.environment = dict(os.environ, CCACHE_BASEDIR=str(folder))
        data = ROOT.parent / "shared" / "data"
        if data.is_dir():
            self.environment.setdefault("AMALGAM_TEST_DATA", str(data))

    def make(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        self.lock = open(self.folder / "lock", "w", encoding="utf-8")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise MutantError(f"another run uses {self.folder}") from None
        commit = must("git", "stash", "create", cwd=ROOT) or must("git", "rev-parse", "HEAD", cwd=ROOT)
        if self.source.exists():
            must("git", "checkout", "--force", "--detach", commit, cwd=self.source)
        else:
            must("git", "worktree", "add", "--detach", self.source, commit, cwd=ROOT)
        must("cmake", "-S", self.source, "-B", self.build_folder, "-G", "Ninja")

    def remove(self):
        call("git", "worktree", "remove", "--force", self.source, cwd=ROOT)
        shutil.rmtree(self.folder, ignore_errors=True)

    def build(self, *targets):
        return call("ninja", "-C", self.build_folder, f"-j{self.jobs}", *targets,
                    env=self.environment)

    def tests_in(self, test, gtest_filter):
        listed = must(self.build_folder / "bin" / test, f"--gtest_filter={gtest_filter}",
                      "--gtest_list_tests", cwd=self.source, env=self.environment)
        return re.findall(r"^  \S+", listed, flags=re.MULTILINE)

    def run(self, test, gtest_filter, limit):
        """(passed, what happened)"""
        try:
            done = call(self.build_folder / "bin" / test, f"--gtest_filter={gtest_filter}",
                        cwd=self.source, env=self.environment, timeout=limit)
        except subprocess.TimeoutExpired:
            return False, f"took longer than {limit:.0f} s"
        failed = re.findall(r"^\[  FAILED  \] ([^ ,]+)", done.stdout, flags=re.MULTILINE)
        if failed:
            return False, failed[0]
        if done.returncode != 0:
            started = re.findall(r"^\[ RUN      \] (\S+)", done.stdout, flags=re.MULTILINE)
            return False, f"ended with {done.returncode} in {started[-1] if started else 'main'}"
        ran = re.search(r"^\[==========\] (\d+) tests? .*ran\.", done.stdout, flags=re.MULTILINE)
        return True, f"{ran.group(1) if ran else 0} passed"


def check_without_mistakes(copy, mutants):
    """What fails anyway would count as caught."""
    built = copy.build(*sorted({m.test for m in mutants}))
    if built.returncode != 0:
        raise MutantError(f"the copy does not build without any mistake:\n{built.stdout[-4000:]}")
    for test in sorted({m.test for m in mutants}):
        filters = sorted({m.filter for m in mutants if m.test == test})
        for gtest_filter in filters:
            if not copy.tests_in(test, gtest_filter):
                raise MutantError(f"{test} {gtest_filter}: there is no such test")
        passed, what = copy.run(test, ":".join(filters), limit=None)
        if not passed:
            raise MutantError(f"{test} fails without any mistake: {what}")
        print(f"without mistakes {test}: {what}", flush=True)


def try_mutant(copy, mutant):
    """(kind, detail)"""
    text = mutated(copy.source, mutant)
    if text is None:
        return "stale", f"the old text must occur once in {mutant.file}"
    path = copy.source / mutant.file
    good = path.read_bytes()
    path.write_text(text, encoding="utf-8")
    try:
        built = copy.build(mutant.test)
        if built.returncode != 0:
            errors = re.findall(r"error: .*", built.stdout)
            return "does not build", errors[0] if errors else built.stdout[-300:]
        passed, what = copy.run(mutant.test, mutant.filter, copy.limit)
    finally:
        path.write_bytes(good)
    if passed:
        return ("explained", mutant.expected) if mutant.expected else ("survived", mutant.mistake)
    return "caught", what + (" (expected to survive)" if mutant.expected else "")


def try_all(copy, mutants):
    results, begin = [], time.monotonic()
    for i, mutant in enumerate(mutants, 1):
        kind, detail = try_mutant(copy, mutant)
        results.append((kind, mutant, detail))
        passed = time.monotonic() - begin
        left = passed / i * (len(mutants) - i) / 60.0
        print(f"[{i:3}/{len(mutants)}] {kind:14} {mutant.name}: {detail}; {left:.0f} min left",
              flush=True)
    return results


def summarise(results, seconds):
    counts = {kind: sum(1 for r in results if r[0] == kind) for kind in KINDS}
    tried = counts["caught"] + counts["survived"] + counts["explained"]
    share = f"{100.0 * counts['caught'] / tried:.1f} % caught" if tried else "nothing tried"
    for kind in ("survived", "stale", "does not build"):
        for result in results:
            if result[0] == kind:
                print(f"{kind}: {result[1].name}: {result[2]}")
    print(", ".join(f"{counts[kind]} {kind}" for kind in KINDS) +
          f"; {share}; {seconds / 60.0:.0f} min")
    return 1 if counts["survived"] or counts["stale"] else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mutants", nargs="*", help="names or globs, such as 'trace/*'; all if none")
    parser.add_argument("--list", action="store_true", help="name them and the mistakes, and end")
    parser.add_argument("--check", action="store_true",
                        help="only say which no longer fit the sources, and end")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="of the build")
    parser.add_argument("--limit", type=float, default=120.0, help="seconds a test may take")
    parser.add_argument("--keep", action="store_true", help="do not remove the copy")
    parser.add_argument("--folder", type=pathlib.Path, help="for the copy; used again, and kept")
    options = parser.parse_args()
    mutants = read_mutants(options.mutants)
    if options.check:
        stale = [m.name for m in mutants if mutated(ROOT, m) is None]
        for name in stale:
            print(f"stale: {name}: the old text must occur once in its file")
        return 1 if stale else 0
    if options.list:
        for m in mutants:
            stale = " (stale)" if mutated(ROOT, m) is None else ""
            print(f"{m.name}{stale}: {m.mistake} [{m.test} {m.filter}]")
        return 0

    begin = time.monotonic()
    # Always the same one, since its path is compiled into the tests.
    folder = options.folder or pathlib.Path(tempfile.gettempdir()) / "amalgam-mutants"
    copy = Copy(folder.resolve(), options.jobs, options.limit)
    copy.make()
    try:
        check_without_mistakes(copy, mutants)
        print(f"built and tested without mistakes: {time.monotonic() - begin:.0f} s", flush=True)
        return summarise(try_all(copy, mutants), time.monotonic() - begin)
    finally:
        if options.keep or options.folder:
            print(f"the copy is kept in {copy.folder}")
        else:
            copy.remove()


if __name__ == "__main__":
    try:
        sys.exit(main())
    except MutantError as error:
        print(f"run.py: {error}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
