#!/usr/bin/env python3
"""Random requests to the server of `orbearing open`: HTTP, JSON, cases and settings that are wrong
in every way. The server goes on, answers a sound request right, and neither it nor its processes crash, stay behind or fill the memory.

By hand and in tools/test --full, which gives it a program with sanitizers:
    FUZZ_SECONDS=600 FUZZ_SEED=1 ORBEARING=build/asan/bin/orbearing python3 tests/interface/page_fuzz.py
A finding names its seed and round: FUZZ_SEED=1 FUZZ_ROUND=17 begins there.
"""

import concurrent.futures
import contextlib
import copy
import json
import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from page import Page
from program import CASES

SECONDS = float(os.environ.get("FUZZ_SECONDS", "4"))
SEED = int(os.environ.get("FUZZ_SEED", "46"))
FIRST = int(os.environ.get("FUZZ_ROUND", "0"))
LONG = SECONDS > 60
AT_ONCE, IN_A_ROUND, ROUNDS_OF_A_SERVER = 6, 24, 40
PATIENCE = 1.5  # s, then the connection is cut
MOST_MEMORY = 1.5e9  # bytes, of the server or of one of its processes
MOST_PROCESSES = 8 + 8 + 4 + 1  # requests, jobs, idle ones, lives as opened
TEMPLATES = {one.stem: one.read_text(encoding="utf-8") for one in sorted((CASES / "templates").glob("*.yaml"))}
KEYS = sorted(set(re.findall(r'"([a-z_0-9]{2,40})": ?\{', (CASES / "case.schema.json").read_text(encoding="utf-8"))))
OPTIONS = {"run": ("fidelity", "gears"), "sweep": ("fidelity", "jobs", "grid_only", "continue"), "modes": ("speed",),
           "crown": ("profile", "tilts", "drops", "spectrum", "shares", "tolerance", "tilt_tolerance", "distribution", "life", "of", "starts", "jobs"),
           "sensitivities": ("result", "by", "fidelity", "jobs"), "signals": ("vary", "fidelity", "noise", "seed", "jobs"), "validate": ("motion", "samples", "jobs")}
FOREIGN = ("output", "resume", "folders", "pdf", "set", "worker", "json", "", "fidelity", "speed", "-o", "help")
COMMANDS = ("check", "check", "check", "check", "run", "run", "run", "sweep", "crown", "mesh", "modes", "stiffness", "sensitivities", "signals", "validate", "report",
            "fmu", "open")
PATHS = ("/", "/opened", "/templates", "/schema/case", "/schema/result", "/schema/x", "/web/app.js", "/web/../open.cpp", "/lib/a/b.js", "/jobs/0001/events",
         "/jobs/0002", "/jobs/99999999999999999999/events", "/request", "/jobs", "/report", "/report?form=pdf", "/units", "/save", "/alive", "/nothing", "/folders",
         "/opened?results=", "/opened?results=..%2F..", "/opened?results=results%00", "*", "")
METHODS = ("GET", "GET", "GET", "POST", "POST", "HEAD", "DELETE", "PUT", "OPTIONS", "CONNECT", "PRI", "get", "", "G\0T", "POST" * 50)
NUMBERS = ("0", "-0.0", "-1", "1", "2", "3.5", "1e308", "-1e308", "1e-320", "1e999", ".nan", ".inf", "-.inf", "NaN", "9" * 400, "18446744073709551616",
           "4294967296", "2147483648", "1000000", "0x10", "1_000", "1e", "--1", "٣")
UNITS = ("", " mm", " um", " N", " kN", " rpm", " kW", " degC", " K", " rad", " deg", " m/s2", " kg", " mm^1000000", " mm mm", " furlong", " 1", " %", " N.m/(rad", " <b>")
WORDS = ("", "~", "null", "true", "[]", "{}", "[1, [2, [3]]]", "&a [*a, *a]", "*none", "!!binary AAAA", "!!python/object:os.system x", "'", '"\\x00"', "|", "? :", "- -",
         "{from: 1 rpm, to: 1e9 rpm, step: 1e-9 rpm}", "{from: 1 rpm, to: 2 rpm, count: 1000000000}", "{file: ../secret.csv}", "{file: /etc/passwd}", "{file: case.yaml}",
         "{file: /dev/zero}", "<script>alert(1)</script>", "%s%n%s", "{}{0}{:>99999999}", "\u202e", "x" * 5000, "[" * 3000, "{a: " * 3000)
DEEP, MANY = "@deep", "@many"  # stand for values that Python writes in no time only as text
VALUES = (DEEP, MANY, None, True, False, 0, -1, 1e308, -1e-320, 2**63, 2**64, 10**400, "", "x", "\0", "\ud800", "é", [], {}, [[]], {"": {}}, [None] * 50, "a" * 100000)


def odd_value(rng, *more):
    """One that is not shared: what it is put into is changed later on."""
    return copy.deepcopy(rng.choice((*VALUES, *more)))


def hostile_value(rng):
    return rng.choice(NUMBERS) + rng.choice(UNITS) if rng.random() < 0.6 else rng.choice(WORDS)


def broken_case(rng):
    """A template with some of its lines changed."""
    lines = rng.choice(list(TEMPLATES.values())).splitlines()
    for _ in range(rng.choice((0, 1, 1, 1, 2, 3, 8))):
        at = rng.randrange(len(lines))
        how = rng.randrange(9)
        key = lines[at].split(":")[0]
        if how <= 3:
            lines[at] = f"{key}: {hostile_value(rng)}"
        elif how == 4:
            lines.insert(at, lines[rng.randrange(len(lines))])
        elif how == 5:
            lines[at] = re.sub(r"[\d.]+", lambda _: rng.choice(NUMBERS), lines[at], count=1)
        elif how == 6:
            lines.insert(at, " " * rng.choice((0, 2, 4)) + f"{rng.choice(KEYS)}: {hostile_value(rng)}")
        elif how == 7:
            lines[at] = lines[at].replace(key.strip(), rng.choice(KEYS), 1)
        elif len(lines) > 1:
            del lines[at]
    return "\n".join(lines) + "\n"


def path_of_input(rng):
    return ".".join(rng.choice(KEYS) for _ in range(rng.choice((1, 2, 2, 2, 3))))


def settings(rng):
    known = ("input.speed", "input.power", "bearing.radial_clearance", "bearing.laminae", "load.radial", "sweep.input.speed", "spectrum", "bearing.designation",
             "bearing.elements", "simulation.most_revolutions", "model", "name", "gearset.planets")
    return [f"{rng.choice(known) if rng.random() < 0.6 else path_of_input(rng)}={hostile_value(rng)}" for _ in range(rng.choice((0, 0, 1, 2)))]


def sound_body(rng):
    body = {"command": rng.choice(COMMANDS), "case_text": broken_case(rng), "settings": settings(rng)}
    if rng.random() < 0.5:
        names = FOREIGN if rng.random() < 0.1 else OPTIONS.get(body["command"], FOREIGN)
        body["options"] = {rng.choice(names): hostile_value(rng) if rng.random() < 0.4 else odd_value(rng, "quasi-static", "dynamic", 1, 2, "6000 rpm", "[0 um, 4 um]", "load.radial")
                           for _ in range(rng.choice((1, 1, 2)))}
    if body["command"] in ("sweep", "run") and rng.random() < 0.9:  # seldom one that takes long
        body["options"] = {"fidelity": "quasi-static", **({"jobs": 1} if body["command"] == "sweep" else {})}
    return body


def places(value, found=None):
    """(container, key) of all within."""
    found = [] if found is None else found
    for key in list(value) if isinstance(value, dict) else range(len(value)):
        found.append((value, key))
        if isinstance(value[key], (dict, list)):
            places(value[key], found)
    return found


def broken_tree(rng, body):
    for _ in range(rng.choice((0, 1, 1, 2))):
        container, key = rng.choice(places(body) or [(body, "x")])
        how = rng.randrange(4)
        if how == 0 and isinstance(container, dict):
            container[rng.choice(("", "command", "continue", "folder", "pdf", "given", "\0", "x" * 3000))] = odd_value(rng)
        elif how == 1 and isinstance(container, dict):
            container.pop(key, None)
        else:
            container[key] = odd_value(rng)
    return body


def nested(rng):
    depth, (opening, closing) = rng.choice((9, 100, 20000, 1000000)), rng.choice(((b"[", b"]"), (b'{"a":', b"}")))
    depth = min(depth, (3 << 20) // len(opening + closing))
    return opening * depth + b"1" + closing * depth


def many_keys(rng):
    return b"{" + b",".join(b'"k%d":1' % i for i in range(rng.choice((100, 300000)))) + b"}"


def broken_text(rng, text):
    data = bytearray(text)
    for _ in range(rng.choice((0, 0, 0, 1, 1, 2, 5))):
        at, how = rng.randrange(len(data) + 1), rng.randrange(7)
        if how == 0:
            data[at:at + 1] = bytes([rng.randrange(256)])
        elif how == 1:
            del data[at:at + rng.choice((1, 5, 1000))]
        elif how == 2:
            data[at:at] = rng.choice((b"\xff", b"\xc3", b"\xed\xa0\x80", b"\0", b"\\u0000", b"\\ud800", b"\\", b'"', b"//", b"/*", b"\xef\xbb\xbf"))
        elif how == 3:
            data[at:at] = rng.choice((b"NaN", b"Infinity", b"-", b"1e99999", b"00", b"true", b",", b":", b"{", b"]")) * rng.choice((1, 1, 40))
        elif how == 4:
            data[at:at] = data[at // 2:at]
        elif how == 5:
            data[at:at] = nested(rng)[:rng.randrange(1, 5000)]
        elif how == 6 and rng.random() < 0.1:
            data[at:at] = b" " * rng.choice((4 << 20, 5 << 20))
    return bytes(data)


def path_and_body(rng, jobs, broken):
    """Of a request that computes, converts or saves; `broken`: its JSON too."""
    kind = rng.choice(("/request",) * 8 + ("/jobs",) * 3 + ("/units", "/units", "/save", "/save", "/report", "/alive"))
    body = sound_body(rng)
    if kind == "/jobs" and rng.random() < 0.4:
        body["continue"] = odd_value(rng, *jobs, *jobs, "9999")
    if kind == "/jobs" and rng.random() < 0.2:
        body["results"] = odd_value(rng, "", "..", "results", "/tmp")
    elif kind == "/units":
        body = {"value": hostile_value(rng), "unit": rng.choice(UNITS)[1:]}
    elif kind == "/save":
        body = {"file": rng.choice(("a.yaml", "b.txt", "../a.yaml", "/tmp/a.yaml", ".yaml", "a\0.yaml", "x" * 200, "case.yaml", "c.html", "a/b.csv")), "text": hostile_value(rng)}
        if rng.random() < 0.4:
            body["checksum"] = odd_value(rng, "0" * 16)
    elif kind == "/report":
        kind += rng.choice(("", "?form=pdf", "?form=", "?form=pdf&form=x"))
        body = {"job": odd_value(rng, *jobs)} if rng.random() < 0.5 else {"case_text": broken_case(rng).replace("step", "stop"), "settings": settings(rng)}
        if not LONG:
            body["settings"] = ["no.such=input"]  # a page takes its time
    data = json.dumps(broken_tree(rng, body) if broken else body, ensure_ascii=rng.random() < 0.5).encode(errors="surrogatepass")
    for mark, written in ((DEEP, nested), (MANY, many_keys)):
        data = data.replace(json.dumps(mark).encode(), written(rng)) if broken else data
    return kind, broken_text(rng, data) if broken else data


def token_of(rng, page):
    return rng.choice((page.token,) * 40 + (page.token[:-1], page.token.upper(), "0" * 32, "", page.token + "\0", "a" * 9000))


def lines_of_head(rng, page, path):
    """Lines behind the first, most of them right."""
    lines = [f"Host: {rng.choice((f'127.0.0.1:{page.port}',) * 40 + (f'localhost:{page.port}', 'example.org', '', f'127.0.0.1:{page.port + 1}', '[::1]'))}"]
    if "token=" not in path:
        lines.append(rng.choice(("X-Orbearing-Token: {}", "X-Orbearing-Token: {}", "x-orbearing-token:{}", f"Cookie: a=b; orbearing_token_{page.port}={{}}; c",
                                 f"Cookie: {';' * 50}orbearing_token_{page.port}={{}}")).format(token_of(rng, page)))
    odd = (f"Origin: http://127.0.0.1:{page.port}", "Origin: null", "Origin: http://example.org", "Connection: keep-alive", "Connection: close", "Expect: 100-continue",
           "Expect: x", "Range: bytes=0-5", "Range: bytes=100000-200000", "Range: bytes=-5", "Range: bytes=5-1", "Range: bytes=" + "0-0," * 900 + "1-1", "Range: x",
           "Accept-Encoding: gzip, br", "Content-Encoding: gzip", "Content-Encoding: br", "Transfer-Encoding: chunked", "Transfer-Encoding: chunked, chunked",
           "Content-Type: multipart/form-data; boundary=x", "Content-Type: multipart/form-data", "Content-Type: application/x-www-form-urlencoded", "Upgrade: h2c",
           "Last-Event-ID: 1", "Last-Event-ID: 999999999", "Last-Event-ID: -1", "Last-Event-ID: 99999999999999999999", "X-Forwarded-Host: example.org", ": empty", "no colon",
           " folded", "A: " + "b" * 8170, "A: " + "b" * 20000, "A:\0", "Ä: ü", f"Host: 127.0.0.1:{page.port}", "REMOTE_ADDR: 8.8.8.8", "Content-Length: 3")
    lines += [rng.choice(odd) for _ in range(rng.choice((0, 0, 0, 1, 1, 2, 4)))]
    if rng.random() < 0.01:
        lines += ["A: b"] * rng.choice((2000, 200000))
    rng.shuffle(lines)
    return lines


def length_of(rng, body):
    if rng.random() < 0.9:
        return [f"Content-Length: {len(body)}"]
    return rng.choice(([], ["Content-Length: -1"], ["Content-Length: 99999999999999999999999"], ["Content-Length: 4194304"], ["Content-Length: 4194305"], ["Content-Length:"],
                       ["Content-Length: 0x10"], ["Content-Length: +5"], [f"Content-Length: {len(body)}", "Content-Length: 0"], [f"Content-Length: {len(body) + 1}"],
                       [f"Content-Length: {max(0, len(body) - 1)}"], ["Content-Length: 1e3"], ["content-length:\t 18446744073709551615"]))


def chunked(rng, body):
    size = rng.choice((b"%x" % len(body), b"-1", b"ffffffffffffffff", b"fffffffff", b"0x5", b"", b"zz", b"%x" % (len(body) + 3)))
    return size + b"\r\n" + body + b"\r\n" + rng.choice((b"0\r\n\r\n", b"0\r\nA: b\r\n\r\n", b""))


def sound_request(rng, page, jobs):
    """Bytes of one whose head is right: what is odd is its JSON, or its case and settings alone."""
    path, body = path_and_body(rng, jobs, rng.random() < 0.4)
    head = f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{page.port}\r\nX-Orbearing-Token: {page.token}\r\nContent-Length: {len(body)}\r\n\r\n"
    return head.encode() + body


def wild_request(rng, page, jobs):
    """Bytes of one whose head is odd."""
    if rng.random() < 0.1:
        return bytes(rng.randrange(256) for _ in range(rng.choice((1, 20, 3000))))
    if rng.random() < 0.5:
        method, (path, body) = "POST", path_and_body(rng, jobs, True)
    else:
        method, path, body = rng.choice(METHODS), rng.choice((*PATHS, *(f"/jobs/{job}/events" for job in jobs), *(f"/jobs/{job}" for job in jobs))), b""
        if rng.random() < 0.2:
            path += rng.choice(("/", "//", "/..", "%00", "%", "%zz", "#x", "?", "?a", "?token", "&" * 3000, "/a" * 3000, "?" + "a=b&" * 1500, " x", "\t", "\u00e9"))
    if rng.random() < 0.3:
        path += ("&" if "?" in path else "?") + f"token={token_of(rng, page)}"
    lines = lines_of_head(rng, page, path)
    if any(line.startswith("Transfer-Encoding") for line in lines) and rng.random() < 0.8:
        body = chunked(rng, body)
    elif method == "POST" or rng.random() < 0.1:
        lines += length_of(rng, body)
    first = f"{method} {path} {rng.choice(('HTTP/1.1',) * 20 + ('HTTP/1.0', 'HTTP/2.0', 'HTTP/9', '', 'http/1.1'))}"
    ends = rng.choice(("\r\n",) * 20 + ("\n", "\r", "\r\n\r\n"))
    return (ends.join([first, *lines, ""]) + ends).encode("utf-8", "surrogateescape") + body


class Sent:
    """What goes through one connection: bytes in parts, and whether it is cut."""

    def __init__(self, rng, page, jobs):
        wild = rng.random() < 0.35
        data = b"".join(wild_request(rng, page, jobs) for _ in range(rng.choice((1,) * 12 + (2, 3)))) if wild else sound_request(rng, page, jobs)
        if rng.random() < 0.05:
            data = data[:rng.randrange(len(data) + 1)]
        at = sorted(rng.randrange(len(data) + 1) for _ in range(rng.choice((0, 0, 0, 1, 3))))
        self.parts = [data[begin:end] for begin, end in zip([0, *at], [*at, len(data)])]
        self.end = rng.choice(("read",) * 20 + ("cut", "half", "first"))

    def answer(self, port):
        """Sends it; the bytes that came back in time."""
        got = b""
        with contextlib.suppress(OSError), contextlib.closing(socket.create_connection(("127.0.0.1", port), timeout=PATIENCE)) as connection:
            with contextlib.suppress(ConnectionError, TimeoutError):
                for part in self.parts:
                    connection.sendall(part)
            if self.end == "half":
                connection.shutdown(socket.SHUT_WR)
            if self.end == "cut":
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
                return got
            until = time.monotonic() + PATIENCE
            while time.monotonic() < until:
                part = connection.recv(65536)
                got = (got + part)[:2_000_000]
                if not part or self.end == "first":
                    break
        return got

    def __str__(self):
        shown = b"".join(self.parts)
        return f"{self.end}: {shown[:1500]!r}{f' and more, {len(shown)} bytes' if len(shown) > 1500 else ''}"


def memory_of(pid):
    """The most that a process held, in bytes."""
    with open(f"/proc/{pid}/status", encoding="utf-8") as status:
        return max((int(line.split()[1]) * 1024 for line in status if line.startswith("VmHWM")), default=0)


def processes_of(pid):
    """The children that it has at this moment, with their memory."""
    found = {}
    for task in os.listdir(f"/proc/{pid}/task"):
        with contextlib.suppress(OSError), open(f"/proc/{pid}/task/{task}/children", encoding="utf-8") as children:
            for child in children.read().split():
                with contextlib.suppress(OSError):
                    found[int(child)] = memory_of(child)
    return found


class Server:
    """A page with what its processes report, and what was seen of them."""

    def __init__(self, kind, place):
        self.place = pathlib.Path(place)
        folder = self.place / "opened"
        folder.mkdir()
        (folder / "case.yaml").write_text(TEMPLATES["roller-bearing"], encoding="utf-8")
        (self.place / "secret.csv").write_text("speed_rpm,torque_N_m,share\n6000,200,1\n", encoding="utf-8")
        (self.place / "reports").mkdir()
        reports = f"log_path={self.place / 'reports' / 'report'}:print_stacktrace=1"
        environment = {**os.environ, "TMPDIR": str(self.place), "ASAN_OPTIONS": reports + ":quarantine_size_mb=16", "UBSAN_OPTIONS": reports}
        self.messages = (self.place / "messages").open("w+", encoding="utf-8", errors="replace")
        self.page = Page(*([folder] if kind == "folder" else [kind] if kind else []), env=environment, cwd=folder, stderr=self.messages)
        self.jobs = []

    def findings(self):
        """What sanitizers reported and crashes printed."""
        texts = [one.read_text(encoding="utf-8", errors="replace") for one in (self.place / "reports").iterdir()]
        texts.append((self.place / "messages").read_text(encoding="utf-8", errors="replace"))
        return [text for text in texts if re.search(r"Sanitizer|runtime error|terminate called|Assertion", text)]

    def takes(self, answer):
        """Jobs that began; and a process that was lost is a finding."""
        if b'{"job":"' in answer:
            self.jobs = [*self.jobs, re.search(rb'\{"job":"(\d+)"', answer).group(1).decode()][-6:]
        return b"its process is gone" not in answer

    def left_over(self):
        """Processes that are still in its folder, a while behind its end."""
        until = time.monotonic() + 10
        while found := [pid for pid in filter(str.isdigit, os.listdir("/proc")) if self.is_within(pid)]:
            if time.monotonic() > until:
                break
            time.sleep(0.1)
        return found

    def is_within(self, pid):
        with contextlib.suppress(OSError):
            return os.readlink(f"/proc/{pid}/cwd").startswith(str(self.place))
        return False

    def end(self):
        try:
            self.page.end(signal.SIGTERM)
        finally:
            self.page.process.kill()
            self.messages.close()


class Fuzzing(unittest.TestCase):
    def test_random_requests(self):
        until = time.monotonic() + SECONDS
        self.count, self.most, number = 0, 0, FIRST
        kinds = ("folder", "duplex", "e-drive", "")
        while number == FIRST or time.monotonic() < until:
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as place:
                server = Server(kinds[number // ROUNDS_OF_A_SERVER % len(kinds)], place)
                try:
                    number = self.rounds(server, number, until)
                finally:
                    server.end()
                self.assertEqual(server.page.process.returncode, 0, server.findings())
                self.assertEqual(server.findings(), [])
                self.assertEqual(server.left_over(), [])
        print(f"{self.count} requests in {number - FIRST} rounds of seed {SEED}; at most {self.most / 1e6:.0f} MB in one process", file=sys.stderr)

    def rounds(self, server, number, until):
        """Those of one server; the number of the next one."""
        first = number
        while number == first or (number % ROUNDS_OF_A_SERVER and time.monotonic() < until):
            rng = random.Random(f"{SEED} {number}")
            sent = [Sent(rng, server.page, list(server.jobs)) for _ in range(IN_A_ROUND)]
            with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
                answers = list(pool.map(lambda one: one.answer(server.page.port), sent))
            self.count += len(sent)
            told = f"FUZZ_SEED={SEED} FUZZ_ROUND={number}"
            for one, answer in zip(sent, answers):
                self.assertTrue(server.takes(answer), f"{told}: a process was lost by {one}\n{answer[-500:]!r}\n{server.findings()}")
                self.assertRegex(answer[:30], rb"^(HTTP/1\.1 [1-5]\d\d [^\0]*)?$", told)
            self.assertTrue(server.page.lives(), f"{told}: the server ended with {server.page.process.poll()}: " + "\n".join([*server.findings(), *map(str, sent)]))
            self.assertEqual(server.findings(), [], f"{told}: " + "\n".join(map(str, sent)))
            self.measure(server, told)
            self.stop_jobs(server)
            self.answers(server, told)
            number += 1
        return number

    def measure(self, server, told):
        processes = {**processes_of(server.page.process.pid), server.page.process.pid: memory_of(server.page.process.pid)}
        self.most = max(self.most, *processes.values())
        self.assertLessEqual(len(processes) - 1, MOST_PROCESSES, told)
        self.assertLess(max(processes.values()), MOST_MEMORY, told)
        self.assertLessEqual(len(os.listdir(f"/proc/{server.page.process.pid}/fd")), 120, told)

    def stop_jobs(self, server):
        for job in server.jobs:
            self.assertIn(server.page.ask("DELETE", f"/jobs/{job}")[0], (200, 404))

    def answers(self, server, told):
        """A sound request, as soon as fewer than eight compute."""
        self.assertEqual(server.page.post("/units", {"value": "3 mm", "unit": "um"}), (200, {"number": 3000.0, "text": "3000 um"}), told)
        until = time.monotonic() + 90
        while (answer := server.page.request("check", TEMPLATES["roller-bearing"]))[0] == 429 and time.monotonic() < until:
            time.sleep(0.2)
        self.assertEqual(answer[0], 200, (told, answer))
        self.checked = getattr(self, "checked", answer[2])
        self.assertEqual(answer[2], self.checked, told)


if __name__ == "__main__":
    unittest.main()
