#!/usr/bin/env python3
"""Records of other programs as load spectra: OpenFAST as text and in its binary forms, CSV of spreadsheets."""

import json
import os
import pathlib
import struct
import tempfile
import unittest

from program import run

REFERENCE = pathlib.Path(os.environ.get("ORBEARING_REFERENCE", "/nowhere"))
NEEDS_REFERENCE = unittest.skipUnless(REFERENCE.is_dir(), "ORBEARING_REFERENCE names no folder of reference data")
SAMPLES = 400
PACKED = 2.0 / 65535  # of the range of a channel: a step of 16 bits
NAMES = ("RotSpeed", "GenTq", "RotTorq", "GenPwr")
UNITS = ("(rpm)", "(kN-m)", "(kN-m)", "(kW)")
CHOICE = ("--torque", "RotTorq", "--speed", "RotSpeed")


def simulation():
    """Times and rows of a made-up simulation: four levels of torque, two of speed, none near the edge of a bin."""
    times = [0.05 * i for i in range(SAMPLES)]
    rows = []
    for i in range(SAMPLES):
        torque = (4100.0, 1000.0, 2200.0, 3100.0)[i % 4] + 20.0 * (i % 5)
        speed = (8.0, 12.0)[i // 3 % 2] + 0.01 * (i % 7)
        rows.append((speed, torque / 97.0, torque, torque * speed * 0.1047))
    return times, rows


def as_text(times, rows, separator="\t"):
    lines = ["", "Predictions were generated on 01-Jan-2026 at 00:00:00 using a program, of a test", " linked with (nothing)", "",
             "Description: made up, 2 lines; of (some) [text]", "",
             separator.join(f"{name:<10}" for name in ("Time", *NAMES)), separator.join(f"{unit:<10}" for unit in ("(s)", *UNITS))]
    lines += [separator.join([f"{time:10.4f}", *(f"{value:.9E}" for value in row)]) for time, row in zip(times, rows)]
    return "\n".join(lines) + "\n"


def as_binary(form, times, rows, names=NAMES, units=UNITS):
    """A file of OpenFAST in one of its forms, by the description of the format."""
    channels, length = len(names), 24 if form == 4 else 10
    columns = list(zip(*rows))
    scales = [65535.0 / (max(column) - min(column)) for column in columns]
    scales = [struct.unpack("<f", struct.pack("<f", scale))[0] for scale in scales]
    offsets = [struct.unpack("<f", struct.pack("<f", -32768.0 - min(column) * scale))[0] for column, scale in zip(columns, scales)]
    head = struct.pack("<h", form) + (struct.pack("<h", length) if form == 4 else b"") + struct.pack("<ii", channels, len(times))
    time_scale = (2**31 - 1) / (times[-1] - times[0])
    head += struct.pack("<dd", time_scale, 0.0) if form == 1 else struct.pack("<dd", times[0], times[1] - times[0])
    if form != 3:
        head += struct.pack(f"<{channels}f", *scales) + struct.pack(f"<{channels}f", *offsets)
    description = b"made up for a test"
    head += struct.pack("<i", len(description)) + description
    head += b"".join(text.encode().ljust(length) for text in ("Time", *names, "(s)", *units))
    if form == 1:
        head += struct.pack(f"<{len(times)}i", *(round((time - times[0]) * time_scale) for time in times))
    if form == 3:
        return head + b"".join(struct.pack(f"<{channels}d", *row) for row in rows)
    packed = ([max(-32768, min(32767, round(value * scale + offset))) for value, scale, offset in zip(row, scales, offsets)] for row in rows)
    return head + b"".join(struct.pack(f"<{channels}h", *row) for row in packed)


class RecordFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, name, content):
        file = self.folder / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def spectrum(self, *arguments):
        result = run("spectrum", *arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def refusal(self, *arguments):
        result = run("spectrum", *arguments, "--json")
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr

    def assert_same_bins(self, one, other, tolerance):
        self.assertEqual(len(one["bins"]), len(other["bins"]))
        for bin_of_one, bin_of_other in zip(one["bins"], other["bins"]):
            self.assertAlmostEqual(bin_of_one["share"], bin_of_other["share"], delta=1e-6)
            for key in ("torque_N_m", "speed_rpm"):
                self.assertAlmostEqual(bin_of_one[key] / bin_of_other[key], 1.0, delta=tolerance)

    def test_one_simulation_as_text_and_in_each_binary_form_gives_the_same_bins(self):
        """One simulation in text and in each binary form gives the same bins."""
        times, rows = simulation()
        text = self.spectrum(self.written("a.out", as_text(times, rows)), *CHOICE, "--bins", "4x2")
        self.assertEqual((text["samples"], len(text["bins"])), (SAMPLES, 8))
        self.assertAlmostEqual(max(one["torque_N_m"] for one in text["bins"]), 4140e3, delta=25e3)  # kN m, not N m
        blanks = self.spectrum(self.written("b.out", as_text(times, rows, "  ")), *CHOICE, "--bins", "4x2")
        self.assert_same_bins(blanks, text, 1e-12)
        for form in (1, 2, 3, 4):
            with self.subTest(form=form):
                binary = self.spectrum(self.written(f"{form}.outb", as_binary(form, times, rows)), *CHOICE, "--bins", "4x2")
                self.assertEqual(binary["samples"], SAMPLES)
                self.assertEqual(binary["warnings"], text["warnings"])
                self.assert_same_bins(binary, text, 1e-9 if form == 3 else 4 * PACKED)

    def test_rows_of_units_in_csv_and_units_of_every_kind(self):
        rows = [(0.0, 10.0, 100.0), (1.0, 12.0, 120.0), (2.0, 12.0, 120.0)]

        def bins(heads, units, speed, torque):
            text = "\n".join([heads, units] + [f"{t},{n * speed},{m * torque}" for t, n, m in rows])
            return self.spectrum(self.written("u.csv", text), "--torque", "M", "--speed", "n", "--time", "t", "--bins", "2x2")

        expected = bins("t,n,M", "s,rpm,N-m", 1.0, 1.0)
        self.assertAlmostEqual(expected["bins"][0]["torque_N_m"], 100.0)
        for units, speed, torque in (("(s),(deg/s),(kN-m)", 6.0, 1e-3), ("[s],[rad/s],[MN.m]", 0.10471975511965977, 1e-6),
                                     ("s,1/min,Nm", 1.0, 1.0), ("s,U/min,kNm", 1.0, 1e-3)):
            with self.subTest(units):
                self.assert_same_bins(bins("t,n,M", units, speed, torque), expected, 1e-9)
        power = [(t, n, n * m * 0.10471975511965977) for t, n, m in rows]
        for unit, factor in (("W", 1.0), ("kW", 1e-3), ("MW", 1e-6)):
            text = "\n".join([f"Time_[s],n_rpm,P ({unit})"] + [f"{t},{n},{p * factor}" for t, n, p in power])
            self.assert_same_bins(self.spectrum(self.written("p.csv", text), "--power", "P", "--speed", "n", "--bins", "2x2"), expected, 1e-9)

    def test_names_with_a_capital(self):
        lower = self.written("a.csv", "time_s,speed_rpm,torque_N_m\n0,1500,100\n1,1500,120\n2,1500,120\n")
        capital = self.written("b.csv", "Time [s],Speed [rpm],Torque [Nm]\n0,1500,100\n1,1500,120\n2,1500,120\n")
        rows = self.written("c.csv", "Time;Speed;Torque\ns;1/min;Nm\n0;1500;100\n1;1500;120\n2;1500;120\n")
        for file in (capital, rows):
            self.assertEqual(self.spectrum(file)["bins"], self.spectrum(lower)["bins"])

    def test_units_are_never_guessed(self):
        file = self.written("n.csv", "Time,RotSpeed,RotTorq\n0,1,2\n1,1,2\n")
        self.assertIn("n.csv:1:1: found time without a unit", self.refusal(file, *CHOICE))
        file = self.written("n.csv", "Time_[s],RotSpeed_[rpm],RotTorq_[kN/m]\n0,1,2\n1,1,2\n")
        self.assertIn("n.csv:1:25: found torque: its unit 'kN/m' does not measure the same", self.refusal(file, *CHOICE))
        file = self.written("n.csv", "Time_s,RotSpeed_rpm,RotTorq_N_m\ns,rpm,kN-m\n0,1,2\n1,1,2\n")
        self.assertIn("n.csv:1:21: found the units 'N.m' and 'kN-m' of 'RotTorq'; required: one of both", self.refusal(file, *CHOICE))

    def test_the_columns_found_are_listed(self):
        times, rows = simulation()
        for name, content in (("a.out", as_text(times, rows)), ("a.outb", as_binary(2, times, rows))):
            message = self.refusal(self.written(name, content))
            self.assertIn("no speed, no torque among the columns Time [s], RotSpeed [rpm], GenTq [kN-m], RotTorq [kN-m], GenPwr [kW]", message)
            self.assertIn("required: --speed COLUMN, --torque COLUMN or --power COLUMN, or names such as speed_rpm, torque_N_m or power_kW", message)
            message = self.refusal(self.folder / name, "--speed", "RotSpeed", "--torque", "RotTorqe")
            self.assertIn("no column 'RotTorqe' of --torque", message)
            self.assertIn("did you mean 'RotTorq'?", message)
        both = self.refusal(self.folder / "a.out", "--speed", "RotSpeed", "--torque", "RotTorq", "--power", "GenPwr")
        self.assertIn("--power: found together with --torque; required: one of both", both)

    def test_damaged_binary_files_are_refused(self):
        times, rows = simulation()
        whole = as_binary(2, times, rows)
        for length in (3, 20, 60, 100, len(whole) - 1):
            self.assertIn("an undamaged binary file of OpenFAST", self.refusal(self.written("d.outb", whole[:length]), *CHOICE))
        for at in (2, 6):  # counts of channels and samples
            for count in (-1, 0, 2**31 - 1):
                damaged = whole[:at] + struct.pack("<i", count) + whole[at + 4:]
                self.assertIn("an undamaged binary file of OpenFAST", self.refusal(self.written("d.outb", damaged), *CHOICE))
        longer = self.spectrum(self.written("l.outb", whole + b"more"), *CHOICE)
        self.assertIn("4 bytes after its 400 samples were not read", longer["warnings"][0])

    def test_spreadsheets_are_read_where_there_is_no_doubt(self):
        english = "time_s,speed_rpm,torque_N_m\n0.0,1500.5,1591.25\n1.0,1500.5,1592.25\n2.0,1400.5,1592.25\n"
        german = english.replace(",", ";").replace(".", ",").replace("\n", "\r\n")
        quoted = "time_s,speed_rpm,torque_N_m\n" + "".join(f'"{a}","{b}","{c}"\n' for a, b, c in (
            line.replace(".", ",").split(";") for line in english.replace(",", ";").splitlines()[1:]))
        expected = self.spectrum(self.written("e.csv", english), "--bins", "2x2")
        self.assertAlmostEqual(expected["bins"][-1]["speed_rpm"], 1500.5)
        for name, content in {"semicolons": german, "mark": b"\xef\xbb\xbf" + german.encode(), "little": german.encode("utf-16"),
                              "big": b"\xfe\xff" + german.encode("utf-16-be"), "tabs": german.replace(";", "\t"), "sep": "sep=;\r\n" + german,
                              "quoted": quoted, "points": english.replace(",", ";"),
                              "latin": ("# f\xfcr eine Pr\xfcfung\n" + english.replace("torque_N_m", "torque_[N\xb7m]")).encode("latin-1")}.items():
            with self.subTest(name):
                found = self.spectrum(self.written(name + ".csv", content), "--bins", "2x2")
                self.assertEqual(found["bins"], expected["bins"])
                self.assertEqual([text for text in found["warnings"] if "Latin-1" not in text], expected["warnings"])
                self.assertEqual(any("Latin-1" in text for text in found["warnings"]), name == "latin")

    def test_what_can_be_read_in_two_ways_is_refused_at_its_place(self):
        for content, place, said in (
                ("time_s,speed_rpm,torque_N_m\n0,1500,5,1591,25\n", "2:10", "a decimal comma splits a number in two"),
                ("time_s;speed_rpm;torque_N_m\n0;1.500;1.591\n1;1.500;1.591\n", "2:3", "'1.500', whose mark can be of decimals or of thousands"),
                ("time_s;speed_rpm;torque_N_m\n0,5;1.500;1.591\n", "2:5", "'1.500', and '0,5' in line 2: both a comma and a point"),
                ("time_s;speed_rpm;torque_N_m\n0;1.500,5;1.591,5\n", "2:3", "'1.500,5' with 2 marks between its digits"),
                ('time_s,speed_rpm,torque_N_m\n"0","1,500","1,591"\n', "2:5", "'1,500', whose mark can be of decimals or of thousands"),
                ('time_s,speed_rpm,torque_N_m\n0.5,"1,500",1591\n', "2:5", "'1,500', and '0.5' in line 2: both a comma and a point"),
                ("time_s;speed_rpm;torque_N_m\n0;1500;1591;3\n", "2:13", "4 values; required: a row of 3 values"),
                ("time_s,speed_rpm,torque_N_m\n0,1500,1591\n1,1500\n", "3:1", "2 values; required: a row of 3 values"),
                ("time_s,speed_rpm,torque_N_m,\xfc\n".encode() + b"0,1500,1591,\xfc\n", "2:13", "a byte that is not UTF-8 in a file whose line 1 holds UTF-8"),
                ("time_s,speed_rpm,torque_N_m\n0,1500,1591\n".encode("utf-16-le"), "1:2", "a zero byte"),
                ("time_s,speed_rpm,torque_N_m\n0,1500,1591\n".encode("utf-16")[:-1], "1:1", "UTF-16 with a character that is not whole")):
            with self.subTest(content=content):
                message = self.refusal(self.written("w.csv", content))
                self.assertTrue(message.startswith(f"{self.folder}/w.csv:{place}: found "), message)
                self.assertIn(said, message)

    def test_codes_of_missing_values_are_no_loads(self):
        head = "time_s,speed_rpm,torque_kN_m\n"
        for code, name, row in (("-999", "torque", "1,{},"), ("-999.25", "torque", "1,{},"), ("-9999", "speed", "1,12,{}"), ("9999", "torque", "1,12,{}"),
                                ("-32768", "torque", "1,12,{}"), ("1e+30", "torque", "1,12,{}"), ("-999", "speed", "1,12,{}")):
            for place in (1, 2, 3):
                rows = [[str(i), "12", "100"] for i in range(4)]
                rows[place][1 if name == "speed" else 2] = code
                content = head + "".join(",".join(one) + "\n" for one in rows)
                message = self.refusal(self.written("c.csv", content))
                self.assertTrue(message.startswith(f"{self.folder}/c.csv:{place + 2}: found {code} as {name}"), message)
        # A record that holds one load from end to end, below 0; a load among its neighbours is a measured one.
        self.assertIn("-999 as torque, a common code of a missing value", self.refusal(self.written("c.csv", head + "0,12,-999\n1,12,-999\n")))
        self.spectrum(self.written("c.csv", head + "0,12,9999\n1,12,9999\n"))
        near = self.spectrum(self.written("c.csv", head + "0,12,-980\n1,12,-999\n2,12,-1010\n"), "--bins", "1x1")
        self.assertEqual(near["samples"], 3)
        # In the unit of the file: -999 kN m, packed or not.
        times, rows = simulation()
        missing = [(speed, tq, -999.0 if i == 7 else torque, power) for i, (speed, tq, torque, power) in enumerate(rows)]
        self.assertIn("a.outb: sample 8: found -999 as torque", self.refusal(self.written("a.outb", as_binary(3, times, missing)), *CHOICE))

    def test_loads_beyond_measure_are_refused(self):
        """Sums of such loads are not finite: a row 'nan,5e+299,1' was written."""
        file, rows = self.written("c.csv", "time_s,speed_rpm,torque_N_m\n0,1000,1e308\n1,1e300,1e308\n2,1,1\n"), self.folder / "rows.csv"
        done = run("spectrum", file, "-o", rows, "--bins", "1x1")
        self.assertEqual((done.returncode, done.stdout, rows.exists()), (2, "", False))
        self.assertIn("c.csv:3: found 1e+300 as speed; required: a measured value; leave out samples without one", done.stderr)

    def test_torque_and_speed_of_two_shafts(self):
        """The rotor's torque at the generator's speed, a gear ratio of 97 between them: 97 times the power that the file states."""
        times, rows = simulation()
        heads = "time_s,speed_rpm,torque_kN_m,power_kW\n"
        content = heads + "".join(f"{time},{97.0 * speed},{torque},{power}\n" for time, (speed, _, torque, power) in zip(times, rows))
        message = self.refusal(self.written("two.csv", content))
        mean = sum(row[3] for row in rows[:-1]) / (len(rows) - 1)
        self.assertIn(f"found a mean power of {mean:.4g} kW, and {97.0 * mean * 0.1047197551 / 0.1047:.4g} kW by torque and speed: they are of two shafts", message)
        self.assertIn("required: torque and speed of one shaft (--torque COLUMN, --speed COLUMN), or power and speed alone (--power COLUMN)", message)
        one = self.spectrum(self.written("one.csv", heads + "".join(f"{time},{speed},{torque},{0.93 * power}\n" for time, (speed, _, torque, power) in zip(times, rows))))
        self.assertIn(f"torque and power found; torque is used: {mean * 0.1047197551 / 0.1047:.4g} kW by torque and speed, {0.93 * mean:.4g} kW by power", one["warnings"][0])
        # By columns that the user names, power is known by its unit.
        head = ("Time", "GenSpeed", *NAMES)
        lines = ["\t".join(head), "\t".join(("(s)", "(rpm)", *UNITS))]
        lines += ["\t".join(f"{value:.6e}" for value in (time, 97.0 * row[0], *row)) for time, row in zip(times, rows)]
        file = self.written("g.out", "\n".join(lines) + "\n")
        mixed = self.spectrum(file, "--torque", "RotTorq", "--speed", "GenSpeed")
        self.assertIn(f"which no column of power has (GenPwr: {mean:.4g} kW). Take torque and speed of one shaft", mixed["warnings"][0])
        for speed, torque in (("RotSpeed", "RotTorq"), ("GenSpeed", "GenTq")):
            self.assertEqual([text for text in self.spectrum(file, "--torque", torque, "--speed", speed)["warnings"] if "column of power" in text], [])

    def test_words_for_missing_values_are_no_units(self):
        for word in ("NaT", "NaN", "n/a", "NULL", "None"):
            content = f"time,speed_rpm,torque_N_m\n{word},{word},{word}\n0,1,2\n1,1,2\n"
            self.assertIn("n.csv:1:1: found time without a unit", self.refusal(self.written("n.csv", content)))

    def test_names_in_a_comment_above_the_rows(self):
        rows = "0 1500 100\n1 1500 120\n2 1500 120\n"
        expected = self.spectrum(self.written("a.csv", "time_s speed_rpm torque_N_m\n" + rows), "--bins", "1x1")["bins"]
        for head in ("# time_s speed_rpm torque_N_m\n", "# a run of today\n#\n#time_s speed_rpm torque_N_m\n", "# time speed torque\n# (s) (rpm) (N-m)\n"):
            self.assertEqual(self.spectrum(self.written("b.csv", head + rows), "--bins", "1x1")["bins"], expected, head)
        commas = "#time_s,speed_rpm,torque_N_m\n" + rows.replace(" ", ", ")
        self.assertEqual(self.spectrum(self.written("c.csv", commas), "--bins", "1x1")["bins"], expected)
        for head in ("", "# a comment of another length\n", "# 1 2 3\n"):
            message = self.refusal(self.written("d.csv", head + rows))
            self.assertIn("found numbers, and no line above them with the names of the columns; required: a first line such as time_s,speed_rpm,torque_N_m", message)
            self.assertNotIn("1500", message)

    def test_files_of_other_programs_are_named(self):
        for name, content, said in (
                ("a.xlsx", b"PK\x03\x04\0\0", "a ZIP file, as an Excel workbook (.xlsx) is one; required: a record over time: CSV, .out or .outb of OpenFAST, Bladed, or "
                                                 "netCDF; save the sheet as CSV"),
                ("a.xls", b"\xd0\xcf\x11\xe0\0", "an Excel workbook (.xls)"), ("a.parquet", b"PAR1\0", "a Parquet file"),
                ("a.feather", b"ARROW1\0", "a Feather file"), ("a.tdms", b"TDSm\0", "a TDMS file of LabVIEW"), ("a.mat", b"MATLAB 5.0 MAT-file, \0", "a MAT-file"),
                ("a.mf4", b"MDF     4.10\0", "a measurement file MDF"), ("a.csv.gz", b"\x1f\x8b\0", "a compressed file (gzip)"),
                ("a.csv.bz2", b"BZh91AY", "a compressed file (bzip2)"), ("a.7z", b"7z\xbc\xaf\x27\x1c\0", "a compressed file (7z)"),
                ("a.csv.xz", b"\xfd7zXZ\0", "a compressed file (xz)"), ("a.rar", b"Rar!\x1a\x07", "a compressed file (rar)"), ("a.res", b"\x48\0\0\0\x09\0", "binary data (.res), as FLEX writes them"),
                ("h.sel", b"____\n  Version ID : HAWC2MB 11.8\n", "names of channels of HAWC2 (.sel), whose data are in the .dat file of that name"),
                ("h.dat", b"0 1 2\n", "data of HAWC2 without names, which are in h.sel")):
            message = self.refusal(self.written(name, content))
            self.assertTrue(message.startswith(f"{self.folder}/{name}: found {said}"), message)
            self.assertNotIn("\0", message)

    BLADED = ("FILE\tx.$04\nACCESS\tS\nFORM\t{form}\nRECL\t4\nFORMAT\t{format}\nNDIMENS\t2\nDIMENS\t3\t{steps}\nGENLAB\t'a'\n"
              "VARIAB\t'Generator speed' 'Time from start' 'Generator torque'\nVARUNIT\tA/T T FL\nAXISLAB\t'Time'\nAXIUNIT\tT\nAXIMETH\t2\nMIN \t1.0\nSTEP\t0.5\n")

    def test_bladed_as_text_and_binary(self):
        rows = [(90.0 + i, 0.0, 1000.0 + 10.0 * i) for i in range(6)]
        options = ("--speed", "Generator speed", "--torque", "Generator torque", "--bins", "1x1")
        csv = "time_s,n_rad_per_s,M_N_m\n" + "".join(f"{1.0 + 0.5 * i},{n},{m}\n" for i, (n, _, m) in enumerate(rows))
        expected = self.spectrum(self.written("a.csv", csv), "--speed", "n", "--torque", "M", "--bins", "1x1")
        for form, kind, content in (("F", "R*4", "".join(f"  {n:.7e}  {t:.7e} {m:.7e}\n" for n, t, m in rows).encode()),
                                    ("U", "R*4", b"".join(struct.pack("<3f", *row) for row in rows)), ("U", "R*8", b"".join(struct.pack("<3d", *row) for row in rows))):
            self.written("x.%04", self.BLADED.format(form=form, format=kind, steps=len(rows)))
            data = self.written("x.$04", content)
            for name in ("x.%04", "x.$04"):
                found = self.spectrum(self.folder / name, *options)
                self.assertEqual((found["samples"], found["duration_s"]), (6, 2.5))
                self.assert_same_bins(found, expected, 1e-7)
            data.write_bytes(content[:-20])  # of text as well the last number as a whole
            self.assertIn("x.$04: found an end within its data", self.refusal(data, *options))
        self.written("x.%04", self.BLADED.format(form="F", format="R*4", steps=6).replace("DIMENS\t3", "DIMENS\t4"))
        self.assertIn("x.%04: found 4 variables and 3 names", self.refusal(data, *options))
        self.written("x.%04", self.BLADED.format(form="F", format="R*4", steps=6).replace("NDIMENS\t2", "NDIMENS\t3"))
        self.assertIn("x.%04: found 3 dimensions; required: output over time alone", self.refusal(data, *options))
        (self.folder / "x.%04").unlink()
        self.assertIn("x.$04: found data of Bladed without the header x.%04", self.refusal(data, *options))

    @NEEDS_REFERENCE
    def test_public_cases_of_others(self):
        """public_cases_2.yaml, foreign_series_files: Bladed 200 rows of 0.05 s, 92.0418 rad/s, 19757.65 N m, 1818529.7 W; others by their kind."""
        files = REFERENCE / "public_cases_2" / "series"
        for name in ("Bladed_out_ascii.%04", "Bladed_out_ascii.$04"):
            found = self.spectrum(files / name, "--speed", "Measured generator speed", "--torque", "Demanded generator torque", "--bins", "1x1", "--exponent", "1")
            self.assertEqual((found["samples"], round(found["duration_s"], 9)), (200, 9.95))
            (one,) = found["bins"]
            # The last sample lasts for no time: of 199. The file's own means of 200 are 92.041807 and 19757.653.
            self.assertAlmostEqual(one["speed_rpm"] * 0.10471975511965977, 92.0418, delta=2e-3)
            self.assertAlmostEqual(one["torque_N_m"], 19757.65, delta=0.5)
            self.assertEqual([text for text in found["warnings"] if "power" in text], [])  # 1818.53 kW beside 1818.53 kW
            self.assertIn("among the columns time [s], Time from start of simulation [s], Demanded power [W]", self.refusal(files / name))
        for name, said in (("ExcelFile_OneSheet.xlsx", "a ZIP file, as an Excel workbook"), ("ParquetFile_test.parquet", "a Parquet file"),
                           ("TDMS_1Grp2Chan_TimeTrack.tdms", "a TDMS file"), ("FLEXOutBinV3.res", "binary data (.res), as FLEX"), ("HAWC2_out_ascii.sel", "names of channels of HAWC2"),
                           ("HAWC2_out_bin.sel", "names of channels of HAWC2"), ("HAWC2_out_bin.dat", "data of HAWC2 without names"),
                           ("BHAWC_out_ascii1.sel", "names of channels of BHAWC"), ("BHAWC_out_ascii1.dat", "data of BHAWC without names")):
            self.assertIn(f"found {said}", self.refusal(files / name), name)
        codes = self.refusal(files / "CSVAutoCommentChar.txt", "--time", "Time", "--speed", "Rotor_Speed", "--torque", "Torque")
        self.assertIn("found time without a unit", codes)
        self.assertIn("found time without a unit", self.refusal(files / "CSVDateNaN.csv"))
        self.assertIn("among the columns ColA, ColB, ColC", self.refusal(files / "CSVColInHeader3.csv"))
        self.assertIn("among the columns Time [s], GenSpeed [rpm]", self.refusal(files / "FASTOut.out"))

    @NEEDS_REFERENCE
    def test_files_of_others(self):
        """../shared/reference/openfast and public_cases openfast_out, german_excel_csv, powershell_utf16."""
        cases = REFERENCE / "public_cases"
        text = self.spectrum(cases / "openfast_like.out", *CHOICE, "--bins", "1x1")
        self.assertAlmostEqual(text["bins"][0]["torque_N_m"], 3955671.0, delta=1000.0)  # N m
        self.assert_same_bins(text, self.spectrum(cases / "openfast_like.csv", *CHOICE, "--bins", "1x1"), 1e-5)
        for name, samples in (("FASTOutBin_ID4", 11), ("fastout_allnodes", 101)):
            self.assertEqual(self.spectrum(REFERENCE / "openfast" / f"{name}.outb", *CHOICE)["samples"], samples)
        found = self.spectrum(REFERENCE / "openfast" / "FASTOutBin.outb", "--power", "GenPwr", "--speed", "RotSpeed", "--bins", "1x1")
        self.assertAlmostEqual(found["bins"][0]["speed_rpm"], 34.24, delta=0.01)
        self.assertIn("among the columns Time [s], GenSpeed [rpm]", self.refusal(REFERENCE / "openfast" / "FASTOut.out"))
        for name, options in (("german_excel_our_names", ()), ("decimal_comma_only", ()), ("latin1_header", ()), ("powershell_utf16", ()),
                              ("german_excel", ("--torque", "Drehmoment", "--speed", "Drehzahl", "--time", "Zeit"))):
            self.assertEqual(self.spectrum(cases / f"{name}.csv", *options, "--bins", "1x1")["bins"][0]["speed_rpm"], 1500.5)
        self.assertIn("unq.csv:2:10: found 5 values (a decimal comma", self.refusal(cases / "unq.csv"))
        self.assertIn("german_excel.csv:1:1: found no time, no speed, no torque among the columns Zeit_s, Drehzahl_rpm, Drehmoment_N_m",
                      self.refusal(cases / "german_excel.csv"))


if __name__ == "__main__":
    unittest.main()
