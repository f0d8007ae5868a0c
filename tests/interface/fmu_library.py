#!/usr/bin/env python3
"""The libraries inside our FMUs: what they export, and that they ask for nothing newer than glibc 2.29."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

SKIPPED = 77
SOURCE = pathlib.Path(os.environ.get("ORBEARING_SOURCE_DIR", "."))
LIBRARIES = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "lib" / "orbearing" / "fmu"
LINUX = LIBRARIES / "linux64" / "orbearing.so"
WINDOWS = LIBRARIES / "win64" / "orbearing.dll"
OLDEST_GLIBC = (2, 29)
# libgcc_s of GCC 4.2 (2007) and newer; a function of a later one would say so.
OLDEST_GCC = (4, 2, 0)
NEEDED = {"libc.so.6", "libm.so.6", "libgcc_s.so.1", "ld-linux-x86-64.so.2"}
WINDOWS_SYSTEM = {"kernel32.dll", "msvcrt.dll"}


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def declared():
    names = set()
    for header in ("fmi2.hpp", "fmi3.hpp"):
        text = (SOURCE / "coupling" / "fmu" / header).read_text()
        names |= set(re.findall(r"^ *F\([^,]*, (fmi[23]\w+)", text, re.MULTILINE))
    return names


def symbols():
    """Dynamic symbols as (name, version or '', defined)."""
    rows = []
    for line in output_of("readelf", "--dyn-syms", "--wide", str(LINUX)).splitlines():
        words = line.split()
        if len(words) >= 8 and words[0].rstrip(":").isdigit():
            name, _, version = words[7].partition("@")
            rows.append((name, version.lstrip("@").split("(")[0], words[6] != "UND"))
    return [row for row in rows if row[0]]


def newest(prefix):
    versions = [tuple(map(int, version[len(prefix):].split(".")))
                for _, version, _ in symbols() if version.startswith(prefix)]
    return max(versions, default=())


class LinuxLibrary(unittest.TestCase):
    def test_floor_of_the_c_library(self):
        found = newest("GLIBC_")
        self.assertGreater(found, (2, 0), "the symbol table was not read")
        self.assertLessEqual(found, OLDEST_GLIBC)
        self.assertLessEqual(newest("GCC_"), OLDEST_GCC)

    def test_brings_its_own_c_plus_plus_library(self):
        self.assertEqual([row for row in symbols() if row[1].startswith(("GLIBCXX_", "CXXABI_"))], [])
        needed = set(re.findall(r"\(NEEDED\).*\[(.*)\]", output_of("readelf", "-d", str(LINUX))))
        self.assertLessEqual(needed, NEEDED)

    def test_shows_the_c_functions_and_nothing_else(self):
        functions = declared()
        self.assertGreater(len(functions), 100)
        self.assertEqual({name for name, _, defined in symbols() if defined}, functions)

    def test_neither_threads_nor_hypot(self):
        undefined = {name for name, _, defined in symbols() if not defined}
        for name in ("hypot", "pthread_create", "_dl_find_object", "pthread_once"):
            self.assertNotIn(name, undefined)


@unittest.skipUnless(WINDOWS.exists(), "no Windows library was built")
class WindowsLibrary(unittest.TestCase):
    def setUp(self):
        tool = shutil.which("x86_64-w64-mingw32-objdump")
        if tool is None:
            self.skipTest("no x86_64-w64-mingw32-objdump")
        self.text = output_of(tool, "-p", str(WINDOWS))

    def test_needs_windows_only(self):
        needed = {name.lower() for name in re.findall(r"DLL Name: (\S+)", self.text)}
        self.assertLessEqual(needed, WINDOWS_SYSTEM)

    def test_shows_the_c_functions_and_nothing_else(self):
        table = self.text[self.text.index("[Ordinal/Name Pointer] Table"):]
        names = set(re.findall(r"^\s*\[ *\d+\][^A-Za-z_]*(\w+)$", table, re.MULTILINE))
        names = {re.sub(r"^.*?(fmi[23])", r"\1", name) for name in names}
        self.assertEqual(names, declared())


if __name__ == "__main__":
    if not LINUX.exists():
        print(f"skipped: no library {LINUX}")
        sys.exit(SKIPPED)
    if re.search(rb"__asan_|__gcov_", LINUX.read_bytes()):
        print("skipped: the library is instrumented")
        sys.exit(SKIPPED)
    unittest.main()
