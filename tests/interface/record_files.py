#!/usr/bin/env python3
"""Records of other programs as load spectra (issue 47, item 2): OpenFAST as text and in its binary forms, CSV of spreadsheets."""

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
        """Issue 47, done when: one simulation in text and in each binary form gives the same bins."""
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

    @NEEDS_REFERENCE
    def test_files_of_others(self):
        """Issue 47, done when: ../shared/reference/openfast and public_cases openfast_out, german_excel_csv, powershell_utf16."""
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
