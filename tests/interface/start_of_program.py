"""What a start of the program loads: libraries of files and servers come when they are used."""

import os
import pathlib
import re
import subprocess
import unittest

PROGRAM = os.environ["ORBEARING"]
LATER = ("netcdf", "hdf5", "curl", "zip", "ssl", "crypto", "brotli", "httplib")


def loaded(file):
    """Names of all libraries that the loader maps before the first instruction."""
    done = subprocess.run([file], env=os.environ | {"LD_TRACE_LOADED_OBJECTS": "1"}, capture_output=True, text=True, check=True)
    return re.findall(r"^\s*(\S+) (?:=>|\()", done.stdout, re.M)


class Start(unittest.TestCase):
    def test_loads_no_library_of_files_or_servers(self):
        names = loaded(PROGRAM)
        self.assertTrue([name for name in names if name.startswith("libstdc++")], names)
        self.assertEqual([name for name in names for part in LATER if part in name], [])

    def test_so_does_the_library(self):
        """As the Python package and other programs load it."""
        library = pathlib.Path(PROGRAM).resolve().parents[1] / "lib" / "liborbearing.so"
        if not library.exists():
            self.skipTest("built without the library of the Python package")
        done = subprocess.run(["objdump", "-p", library], capture_output=True, text=True, check=True)
        needed = re.findall(r"^\s*NEEDED\s+(\S+)", done.stdout, re.M)
        self.assertTrue(needed)
        self.assertEqual([name for name in needed for part in LATER if part in name], [])


if __name__ == "__main__":
    unittest.main()
