#!/usr/bin/env python3
"""`orbearing open` over HTTP: who may ask, what is answered, jobs, folders, how it ends."""

import concurrent.futures
import contextlib
import faulthandler
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.parse
import urllib.request

from page import Page, lives_in, page
from program import CASES, REDUCER, package, run

TEMPLATE = (CASES / "templates" / "e-drive.yaml").read_text(encoding="utf-8")
ROLLERS = (CASES / "templates" / "roller-bearing.yaml").read_text(encoding="utf-8")
BRIEF = ("sweep.input.speed=[4000 rpm, 6000 rpm, 8000 rpm]",)
FOUR_SPEEDS = ("sweep.input.speed=[4000 rpm, 5000 rpm, 6000 rpm, 7000 rpm]", "simulation.most_revolutions=2",
               "simulation.observed_revolutions=1", "simulation.length_error=1e-5 mm")
SLOW = {"fidelity": "dynamic", "grid_only": True, "jobs": 1}
# As the program finds its files: those of the source tree where they are there.
SOURCE_FILES = CASES.parent / "page" / "web"
HARMFUL = "<script>alert(1)</script><img src=x onerror=alert(2)>"


def page_files():
    """The folder that is served."""
    installed = pathlib.Path(os.environ["ORBEARING"]).resolve().parents[1] / "share" / "orbearing" / "page"
    return installed if (installed / "index.html").exists() else SOURCE_FILES.resolve()


class Shared(unittest.TestCase):
    """One program for all tests that leave it as it is."""

    @classmethod
    def setUpClass(cls):
        place = tempfile.TemporaryDirectory()
        cls.addClassCleanup(place.cleanup)
        cls.folder = pathlib.Path(place.name) / "opened"
        cls.folder.mkdir()
        (cls.folder / "case.yaml").write_text(TEMPLATE, encoding="utf-8")
        (cls.folder.parent / "secret.csv").write_text("speed_rpm,torque_N_m,share\n6000,200,1\n", encoding="utf-8")
        cls.page = Page(cls.folder / "case.yaml")
        cls.addClassCleanup(cls.page.end)

    def tearDown(self):
        self.assertTrue(self.page.lives())

    def refused(self, status, method="GET", path="/opened", **more):
        found, headers, data = self.page.ask(method, path, **more)
        self.assertEqual(found, status, data)
        self.assertEqual(headers["Cache-Control"], "no-store")
        return json.loads(data)


class Access(Shared):
    """Item 5: loopback, token, Host, Origin."""

    def test_the_address_is_the_first_line_and_has_a_token(self):
        self.assertRegex(self.page.address, r"^http://127\.0\.0\.1:\d+/\?token=[0-9a-f]{32}$")
        with page("duplex") as other:
            self.assertNotEqual(other.token, self.page.token)

    def test_it_listens_on_the_loopback_address_alone(self):
        listening = subprocess.run(["ss", "-ltnH"], capture_output=True, text=True, check=False) if os.path.exists("/usr/bin/ss") else None
        if listening is None:
            self.skipTest("no ss (iproute2)")
        at = [line.split()[3] for line in listening.stdout.splitlines() if line.split()[3].endswith(f":{self.page.port}")]
        self.assertEqual(at, [f"127.0.0.1:{self.page.port}"])

    def test_without_the_token_all_is_refused(self):
        for method, path in (("GET", "/"), ("GET", "/opened"), ("GET", "/web/index.html"), ("GET", "/schema/case"), ("GET", "/nothing"),
                             ("POST", "/request"), ("POST", "/jobs"), ("POST", "/save"), ("POST", "/closed"), ("DELETE", "/jobs/0001")):
            with self.subTest(path=path):
                body = None if method != "POST" else "{}"
                self.refused(403, method, path, token=False, body=body)
                self.refused(403, method, path, token=False, body=body, headers={"X-Orbearing-Token": "0" * 32})
                self.refused(403, method, path, token=False, body=body, headers={"X-Orbearing-Token": self.page.token[:-1]})

    def cookie(self, running, query):
        """Name, value and path of the cookie that an address gives."""
        status, headers, document = running.ask("GET", query, token=False)
        self.assertEqual(status, 200)
        given = re.fullmatch(r"(orbearing_token_\d+)=([0-9a-f]{32}); HttpOnly; SameSite=Strict; Path=(/page-[0-9a-f]{32})/", headers["Set-Cookie"])
        self.assertEqual(given[1], f"orbearing_token_{running.port}")
        return (*given.groups(), document.decode())

    def test_the_token_counts_as_query_and_header_and_a_cookie_below_its_path(self):
        """A browser sends a cookie to every port of a host, but to its own path alone, which no other program knows."""
        name, value, home, document = self.cookie(self.page, f"/?token={self.page.token}")
        self.assertNotEqual(value, self.page.token)
        self.assertEqual(set(re.findall(r'(?:href|src)="([^"]*web/)', document)), {f"{home}/web/"})
        for cookie in (f"{name}={value}", f"a=b; {name}={value}; c=d"):
            for path in ("/", "/opened", "/web/app.js", "/schema/case", "/templates"):
                self.assertEqual(self.page.ask("GET", home + path, token=False, headers={"Cookie": cookie})[0], 200, path)
                self.refused(403, path=path, token=False, headers={"Cookie": cookie})
        self.assertEqual(self.page.ask("POST", f"{home}/request", {"command": "check", "case_text": ROLLERS}, token=False, headers={"Cookie": f"{name}={value}"})[0], 200)
        for cookie in (f"x{name}={value}", f"orbearing_token={value}", f"{name}={self.page.token}", f"{name}={value[:-1]}", ""):
            self.refused(403, path=f"{home}/opened", token=False, headers={"Cookie": cookie})
        self.refused(403, path=f"{home}/opened", token=False)
        self.refused(403, path=f"{home}x/opened", token=False, headers={"Cookie": f"{name}={value}"})
        for other in ("/page-" + "0" * 32, home + home):
            self.assertIn(self.page.ask("GET", other + "/opened", token=False, headers={"Cookie": f"{name}={value}"})[0], (403, 404))

    def test_the_browser_is_started_with_a_file_that_its_owner_alone_reads(self):
        """Arguments of processes are visible to all users: they hold no token. The token in the file is of one use."""
        with tempfile.TemporaryDirectory() as place:
            seen, program = pathlib.Path(place) / "seen", pathlib.Path(place) / "xdg-open"
            program.write_text(f'#!/bin/sh\nstat -c "%a" "$1" "$(dirname "$1")" > {seen}.tmp; echo "$@" >> {seen}.tmp; cat "$1" >> {seen}.tmp; mv {seen}.tmp {seen}\n', encoding="utf-8")
            program.chmod(0o755)
            running = Page("duplex", browser=True, env={**os.environ, "PATH": f"{place}:{os.environ['PATH']}"})
            try:
                until = time.monotonic() + 60
                while not seen.exists() and time.monotonic() < until:
                    time.sleep(0.05)
                mode, mode_of_folder, argument, *text = seen.read_text(encoding="utf-8").splitlines()
                self.assertEqual((mode, mode_of_folder), ("600", "700"))
                self.assertTrue(argument.endswith("/open.html"))
                once = re.search(r'url=http://127\.0\.0\.1:(\d+)(/\?once=([0-9a-f]{32}))"', "\n".join(text))
                self.assertEqual(int(once[1]), running.port)
                for process in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
                    with contextlib.suppress(OSError):
                        words = process.read_bytes().decode(errors="replace")
                        self.assertNotIn(once[3], words)
                        self.assertNotIn(running.token, words)
                self.assertNotIn(running.token, "".join(text))
                self.assertEqual(running.ask("HEAD", once[2], token=False)[0], 403)  # what looks ahead does not use it up
                name, value, home, document = self.cookie(running, once[2])
                self.assertIn(f'content="0; url={home}/"', document)
                self.assertEqual(running.ask("GET", once[2], token=False)[0], 403)
                self.assertEqual(running.ask("GET", f"{home}/opened", token=False, headers={"Cookie": f"{name}={value}"})[0], 200)
                self.assertEqual(running.ask("GET", f"/opened?once={once[3]}", token=False)[0], 403)
            finally:
                running.end()
            self.assertFalse(pathlib.Path(argument).parent.exists())

    def test_other_hosts_and_origins_are_refused(self):
        for host in ("example.org", f"example.org:{self.page.port}", "127.0.0.1", f"127.0.0.1:{self.page.port + 1}", ""):
            self.refused(403, headers={"Host": host})
        self.assertEqual(self.page.ask("GET", "/opened", headers={"Host": f"localhost:{self.page.port}"})[0], 200)
        for origin in ("null", "http://example.org", f"https://127.0.0.1:{self.page.port}", f"http://127.0.0.1:{self.page.port + 1}",
                       f"http://127.0.0.1:{self.page.port}.example.org"):
            self.refused(403, headers={"Origin": origin})
        self.assertEqual(self.page.ask("GET", "/opened", headers={"Origin": f"http://127.0.0.1:{self.page.port}"})[0], 200)

    def test_headers_of_all_answers(self):
        for path in ("/", "/opened", "/nothing", "/web/index.html"):
            headers = self.page.ask("GET", path)[1]
            self.assertEqual((headers["Cache-Control"], headers["X-Content-Type-Options"], headers["Referrer-Policy"]),
                             ("no-store", "nosniff", "no-referrer"))
            self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
            self.assertNotIn("Access-Control-Allow-Origin", headers)


class Documents(Shared):
    """What is in the document is of the file as it is now."""

    def test_the_file_is_read_at_each_request(self):
        file = self.folder / "case.yaml"
        changed = TEMPLATE.replace("speed: 9000 rpm", "speed: 8000 rpm")
        self.assertNotEqual(changed, TEMPLATE)
        before = lives_in(self.page.ask("GET", "/")[2].decode())
        file.write_text(changed, encoding="utf-8")
        try:
            opened, document = self.page.get("/opened"), self.page.ask("GET", "/")[2].decode()
            self.assertEqual(opened["text"], changed)
            self.assertIn("speed: 8000 rpm", document)
            point = json.loads(run("run", file, "--json").stdout)["points"][0]
            lives = lives_in(document)
            self.assertEqual(lives["L10h"], round(point["L10h"]))
            self.assertNotEqual(lives["L10h"], before["L10h"])
            file.unlink()
            opened = self.page.get("/opened")
            self.assertEqual(opened["text"], changed)
            self.assertIn("case.yaml", opened["error"])
        finally:
            file.write_text(TEMPLATE, encoding="utf-8")
        opened = self.page.get("/opened")
        self.assertEqual((opened["text"], opened.get("error")), (TEMPLATE, None))

    def test_lives_as_opened_stand_in_the_document_in_whole_hours(self):
        document = self.page.ask("GET", "/")[2].decode()
        point = json.loads(run("run", self.folder / "case.yaml", "--json").stdout)["points"][0]
        lives = lives_in(document)
        self.assertEqual(set(lives), {"L10h", "L10rh", "L10mh", "L10mrh", "life_h", "system_L10h", "system_L10rh", "system_L10mh",
                                      "system_L10mrh", "system_life_h"})
        for key, hours in lives.items():
            self.assertEqual(hours, round(point[key]), key)
        inside = re.search(r'<script type="application/json" id="opened">(.*?)</script>', document, re.DOTALL).group(1)
        self.assertEqual(json.loads(inside), self.page.get("/opened"))

    def test_what_was_opened(self):
        opened = self.page.get("/opened")
        self.assertEqual((opened["kind"], opened["file"], opened["text"], opened["writable"]), ("case", "case.yaml", TEMPLATE, True))
        self.assertEqual(opened["version"], run("--version").stdout.strip())

    def test_templates_and_schemas(self):
        found = self.page.get("/templates")
        self.assertEqual([one["name"] for one in found],
                         ["wind-stage", "e-drive", "industrial", "roller-bearing", "ball-bearing", "duplex", "defect"])
        self.assertEqual(found[1]["text"], TEMPLATE)
        for which in ("case", "result"):
            self.assertEqual(self.page.get(f"/schema/{which}"), json.loads((CASES / f"{which}.schema.json").read_text(encoding="utf-8")))

    def test_no_path_leads_out_of_the_folders(self):
        for path in ("/web/../page_server.cpp", "/web/..%2fpage_server.cpp", "/web/%2e%2e/page_server.cpp", "/web//etc/passwd",
                     "/web/....//page_server.cpp", "/lib/../../../etc/passwd", "/lib/%2fetc%2fpasswd", "/web/.hidden.js",
                     "/web/index.html%00.js", "/schema/../README", "/schema/case%2f..%2f..%2fREADME", "/../../../etc/passwd",
                     "/web/index.html/", "/web/\\..\\page_server.cpp", "/jobs/../../etc/events", "/web/" + "a/" * 2000 + "b.js"):
            with self.subTest(path=path[:60]):
                self.assertIn(self.page.ask("GET", path)[0], (400, 404))

    def test_no_path_leads_to_a_file_that_is_there(self):
        """Each attack is at a file that exists, of a kind that is served: it fails by the check of the path alone."""
        secret = self.folder.parent / "secret.json"
        secret.write_text('{"secret": true}', encoding="utf-8")
        (self.folder.parent / ".hidden.json").write_text("{}", encoding="utf-8")
        files = page_files()
        up = "../" * 30
        attacks = [f"/web/{up}{str(secret)[1:]}", f"/web//{str(secret)[1:]}", f"/web/./{up}{str(secret)[1:]}", f"/web/../{files.name}/index.html",
                   f"/web/%2e%2e/{files.name}/index.html", f"/web/..%2f{files.name}%2findex.html", f"/web/{up}{str(CASES / 'case.schema.json')[1:]}",
                   f"/web/{os.path.relpath(CASES / 'case.schema.json', files)}", "/web/./index.html", f"/web/{up}{str(self.folder.parent)[1:]}/.hidden.json",
                   f"/lib/{up}{str(secret)[1:]}", f"/lib//{str(secret)[1:]}"]
        attacks += [one.replace("../", "%2e%2e%2f") for one in attacks if "../" in one]
        for path in attacks:
            local = urllib.parse.unquote(path.split("/", 2)[2])
            self.assertTrue((files / local).is_file() or path.startswith("/lib/"), f"no file is at {path}")
            with self.subTest(path=path[:60]):
                self.assertIn(self.page.ask("GET", path)[0], (400, 404))
        self.assertEqual(self.page.ask("GET", "/web/index.html")[0], 200)

    def test_no_name_leads_to_results_that_are_there(self):
        """Folders of results beside the opened one, and links to them."""
        outside = self.folder.parent / "outside"
        outside.mkdir(exist_ok=True)
        done = run("sweep", self.folder / "case.yaml", "-o", outside / "results", "--grid-only", "--quiet", "--set", BRIEF[0])
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.copytree(outside / "results", self.folder / ".results", dirs_exist_ok=True)
        shutil.copytree(outside / "results", self.folder / "own", dirs_exist_ok=True)
        (self.folder / "link").symlink_to(outside / "results")
        self.assertEqual(len(self.page.get("/opened?results=own")["points"]), 3)
        for name in ("../outside/results", str(outside / "results"), "own/../../outside/results", "./own", "own/", ".results", "link", "own\0"):
            with self.subTest(name=name):
                self.assertEqual(self.page.ask("GET", "/opened?results=" + urllib.parse.quote(name, safe=""))[0], 422)
                status, answer = self.page.post("/jobs", {"command": "sweep", "case_text": TEMPLATE, "results": name})
                self.assertEqual((status, answer["code"]), (422, 2), answer)
        for name in ("own", ".results"):
            shutil.rmtree(self.folder / name)
        (self.folder / "link").unlink()

    def test_units(self):
        self.assertEqual(self.page.post("/units", {"value": "3 mm", "unit": "um"}), (200, {"number": 3000.0, "text": "3000 um"}))
        self.assertEqual(self.page.post("/units", {"value": "0.1 mm", "unit": "mm"})[1]["text"], "0.1 mm")
        for target in ("m 1000", "1000 m", "m @ 3", "2 mm", ""):  # numbers and origins are no units
            status, answer = self.page.post("/units", {"value": "3 mm", "unit": target})
            self.assertEqual((status, answer["code"]), (422, 2), target)
            self.assertIn("unit", answer["errors"][0])
        for value, unit in (("3 mm", "N"), ("mm", "um"), ("3 furlongs of it", "m"), ("3", "m"), ("1e999 mm", "m"), ("3 mm", "<b>")):
            status, answer = self.page.post("/units", {"value": value, "unit": unit})
            self.assertEqual((status, answer["code"]), (422, 2), value)
        for body in ([], {"value": 3, "unit": "m"}, {}):
            self.assertEqual(self.page.post("/units", body)[0], 422)


class Requests(Shared):
    def test_the_answer_is_that_of_json_to_the_byte(self):
        """Item 2: one request = the JSON of --json, with the settings and options of the command line."""
        for command, case, options, words in (
                ("check", TEMPLATE, {}, []), ("run", TEMPLATE, {}, []), ("run", ROLLERS, {}, []), ("mesh", TEMPLATE, {}, []),
                ("modes", TEMPLATE, {"speed": "6000 rpm"}, ["--speed", "6000 rpm"]),
                ("stiffness", ROLLERS, {}, []),
                ("sweep", TEMPLATE, {"grid_only": True, "jobs": 1}, ["--grid-only", "--jobs=1"]),
                ("sensitivities", ROLLERS, {"by": ["load.radial"]}, ["--by", "load.radial"])):
            with self.subTest(command=command):
                settings = ["bearing.clearance_class=C3"] + (list(BRIEF) if command == "sweep" else [])
                with tempfile.TemporaryDirectory() as folder:
                    file = pathlib.Path(folder) / "case.yaml"
                    file.write_text(case, encoding="utf-8")
                    expected = subprocess.run([os.environ["ORBEARING"], command, "case.yaml", "--json", *words,
                                               *[word for one in settings for word in ("--set", one)]], cwd=folder, capture_output=True, check=True)
                status, headers, data = self.page.request(command, case, settings, **options)
                self.assertEqual(status, 200, data)
                self.assertEqual(data, expected.stdout)
                self.assertEqual(headers["X-Orbearing-Code"], "0")

    def test_mistakes_are_the_lines_of_standard_error(self):
        wrong = TEMPLATE.replace("module: 2.5 mm", "module: 2.5 N").replace("planets: 4", "plants: 4")
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "case.yaml").write_text(wrong, encoding="utf-8")
            expected = subprocess.run([os.environ["ORBEARING"], "check", "case.yaml", "--set", "input.power=hot"], cwd=folder,
                                      capture_output=True, text=True, check=False)
        self.assertEqual(expected.returncode, 2)
        status, _, data = self.page.request("check", wrong, ["input.power=hot"])
        answer = json.loads(data)
        self.assertEqual((status, answer["code"]), (422, 2))
        self.assertEqual(answer["errors"], expected.stderr.splitlines())
        self.assertGreater(len(answer["errors"]), 2)

    def test_a_failed_point_keeps_its_row(self):
        status, headers, data = self.page.request("run", TEMPLATE, ["bearing.radial_clearance=2 mm", "bearing.clearance_class=null"])
        if status == 200:
            self.assertIn(headers["X-Orbearing-Code"], ("0", "1"))
        else:
            self.assertIn(status, (422, 500))
            self.assertTrue(json.loads(data)["errors"])

    def test_unknown_keys_and_other_types_are_refused(self):
        case = ROLLERS
        for body, said in (({"command": "run", "case_text": case, "shell": "ls"}, "shell"),
                           ({"command": "run", "case_text": case, "continue": "0001"}, "continue"),
                           ({"command": "fmu", "case_text": case}, "fmu"), ({"command": "report", "case_text": case}, "report"),
                           ({"command": "merge", "case_text": case}, "merge"), ({"command": ["run"], "case_text": case}, "command"),
                           ({"case_text": case}, "command"), ({"command": "run"}, "case_text"), ({"command": "run", "case_text": 3}, "case_text"),
                           ({"command": "validate", "case_text": case}, "case_text"),
                           ({"command": "run", "case_text": case, "settings": "a=b"}, "settings"),
                           ({"command": "run", "case_text": case, "settings": [1]}, "settings"),
                           ({"command": "run", "case_text": case, "options": []}, "options"),
                           ({"command": "run", "case_text": case, "options": {"output": "/tmp/x"}}, "output"),
                           ({"command": "run", "case_text": case, "options": {"resume": True}}, "resume"),
                           ({"command": "run", "case_text": case, "options": {"fidelity=dynamic --output": "x"}}, "fidelity"),
                           ({"command": "sweep", "case_text": case, "options": {"jobs": 100000}}, "jobs"),
                           ({"command": "sweep", "case_text": case, "options": {"jobs": [[[1]]]}}, "jobs"),
                           ([], "object"), ("run", "object"), (None, "object")):
            with self.subTest(body=str(body)[:80]):
                status, answer = self.page.post("/request", json.dumps(body))
                self.assertEqual((status, answer["code"]), (422, 2), answer)
                self.assertTrue(any(said in line for line in answer["errors"]), answer)

    def test_what_is_no_json_is_refused(self):
        for body in (b"", b"{", b"\xff\xfe", b'{"command": "run"', b"[" * 1000000, b"nan"):
            self.assertIn(self.page.ask("POST", "/request", body)[0], (400, 422))
        deep = json.dumps({"command": "check", "case_text": "a: " + "[" * 100000})
        self.assertEqual(self.page.ask("POST", "/request", deep)[0], 422)
        self.assertEqual(self.page.request("check", "")[0], 422)

    def test_bodies_without_measure_are_refused(self):
        """Item 5: what is nested deeply or has many keys neither overflows the stack nor is read to its end."""
        for key in ("continue", "options", "settings", "x"):
            for value in ("[" * 1000000 + "]" * 1000000, '{"a":' * 500000 + "1" + "}" * 500000, "{" + ",".join(f'"k{i}":1' for i in range(300000)) + "}"):
                body = f'{{"command": "sweep", "case_text": "name: a", "{key}": {value}}}'
                status, answer = self.page.post("/jobs", body)
                self.assertEqual((status, answer["code"]), (422, 2))
                self.assertRegex(answer["errors"][0], "^request: found more than (8 levels of objects and lists|200 keys); required: fewer$")

    def test_no_parts_are_sent(self):
        """A range beyond the end of an answer would read other memory."""
        for parts in ("bytes=0-5", "bytes=1000000-2000000", "bytes=-5", "bytes=0-1,5-6", "x"):
            status, _, data = self.page.ask("GET", "/templates", headers={"Range": parts})
            self.assertEqual((status, data), (416, b""), parts)

    def test_heads_and_bodies_without_an_end_are_bounded(self):
        """Item 5: larger than 4 MB, also where no length says so."""
        begin = f"Host: 127.0.0.1:{self.page.port}\r\nX-Orbearing-Token: {self.page.token}\r\n"
        for head, part in ((f"POST /request HTTP/1.1\r\n{begin}\r\n", b"x" * 1000), (f"GET / HTTP/1.1\r\n{begin}", b"a: " + b"b" * 995 + b"\r\n")):
            with contextlib.closing(socket.create_connection(("127.0.0.1", self.page.port), timeout=20)) as raw:
                raw.sendall(head.encode())
                with self.assertRaises(ConnectionError):
                    for _ in range(20000):  # 20 MB
                        raw.sendall(part)
        for lengths in ([], ["3", "4"]):
            with contextlib.closing(socket.create_connection(("127.0.0.1", self.page.port), timeout=20)) as raw:
                raw.sendall((f"POST /units HTTP/1.1\r\n{begin}" + "".join(f"Content-Length: {one}\r\n" for one in lengths) + "\r\n").encode())
                self.assertIn(b" 411 ", raw.recv(100))

    def test_files_that_a_case_names_are_of_the_opened_folder(self):
        """Item 5: no file is read outside the folder that was opened."""
        (self.folder / "loads.csv").write_text("speed_rpm,torque_N_m,share\n6000,200,1\n", encoding="utf-8")
        (self.folder / "link.csv").symlink_to(self.folder.parent / "secret.csv")
        self.assertEqual(self.page.request("run", TEMPLATE, ["spectrum={file: loads.csv}"])[0], 200)
        for name in ("../secret.csv", str(self.folder.parent / "secret.csv"), "/etc/passwd", "link.csv", "../opened/../secret.csv"):
            status, _, data = self.page.request("run", TEMPLATE, [f"spectrum={{file: {name}}}"])
            self.assertEqual(status, 422, name)
            self.assertIn("in the folder that was opened is required", data.decode())

    def test_names_of_cases_are_text(self):
        """Item 5: markup in a name or a source stays text, in the document and in the report."""
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place) / "case.yaml"
            text = ROLLERS.replace("name: roller_bearing", f"name: '{HARMFUL}'").replace("source: template", f"source: '{HARMFUL}' #")
            file.write_text(text + f"# </script>{HARMFUL}\n", encoding="utf-8")
            named = pathlib.Path(place) / "<img src=x onerror=alert(3)>.yaml"
            named.write_text(text, encoding="utf-8")
            for one in (file, named):
                with page(one) as running:
                    document = running.ask("GET", "/")[2].decode()
                    self.assertTrue(lives_in(document) or "No lives" in document)
                    self.assertNotIn("<img", document)
                    self.assertNotIn("<script>alert", document)
                    self.assertEqual(document.count("</script>"), document.count("<script"))
                    self.assertEqual(running.get("/opened")["text"], one.read_text(encoding="utf-8"))

    def test_sizes_are_bounded(self):
        """Item 5: requests larger than 4 MB are refused."""
        for megabytes in (5, 100):
            with self.subTest(megabytes=megabytes):
                try:
                    self.refused(413, "POST", "/request", body=b"x" * (megabytes << 20))
                except (ConnectionError, TimeoutError):
                    pass  # cut while it was sent
        with contextlib.closing(socket.create_connection(("127.0.0.1", self.page.port))) as raw:
            raw.sendall((f"POST /request HTTP/1.1\r\nHost: 127.0.0.1:{self.page.port}\r\nX-Orbearing-Token: {self.page.token}\r\n"
                         "Transfer-Encoding: chunked\r\n\r\n").encode())
            self.assertIn(b" 411 ", raw.recv(100))
        self.refused(415, "POST", "/request", body=b"x", headers={"Content-Encoding": "gzip"})
        self.refused(415, "POST", "/save", body=b"x", headers={"Content-Type": "multipart/form-data; boundary=x"})

    def test_two_hundred_at_once(self):
        """Item 5: more than eight at a time are refused, and the server goes on."""
        def ask(_):
            try:
                return self.page.request("run", TEMPLATE)[0]
            except (ConnectionError, TimeoutError):
                return "cut"
        with concurrent.futures.ThreadPoolExecutor(200) as pool:
            found = list(pool.map(ask, range(200)))
        self.assertLessEqual(set(found), {200, 429, "cut"})
        self.assertIn(200, found)
        self.assertIn(429, found)
        self.assertLess(found.count("cut"), 20)
        self.assertEqual(self.page.request("run", ROLLERS)[0], 200)

    def test_cut_connections(self):
        body = json.dumps({"command": "run", "case_text": TEMPLATE}).encode()
        head = (f"POST /request HTTP/1.1\r\nHost: 127.0.0.1:{self.page.port}\r\nX-Orbearing-Token: {self.page.token}\r\n"
                f"Content-Length: {len(body)}\r\n\r\n").encode()
        for sent in (b"", b"G", b"GET / HTTP/1.1\r\n", head[:60], head, head + body[:100], head + body, b"\0" * 3000, b"A" * 20000 + b"\r\n\r\n"):
            for _ in range(3):
                with contextlib.closing(socket.create_connection(("127.0.0.1", self.page.port))) as raw:
                    with contextlib.suppress(ConnectionError):
                        raw.sendall(sent)
                    raw.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")  # cut, not closed
        self.assertEqual(self.page.request("run", ROLLERS)[0], 200)

    def test_methods(self):
        for method in ("PUT", "PATCH", "OPTIONS", "TRACE", "CONNECT", "FOO"):
            self.assertIn(self.page.ask(method, "/opened")[0], (400, 404, 405), method)
        self.assertEqual(self.page.ask("HEAD", "/opened")[0], 200)
        self.assertEqual(self.page.ask("GET", "/request")[0], 404)


class Saving(Shared):
    def test_a_change_of_somebody_else_is_not_written_over(self):
        """Save states the version that it began with; where the file has another one, nothing is written."""
        file = self.folder / "shared.yaml"

        def put(text, *version):
            status, _, data = self.page.ask("POST", "/save", {"file": file.name, "text": text, **({"checksum": version[0]} if version else {})})
            return status, json.loads(data)
        first = put("a: 1\n", "")
        self.assertEqual((first[0], first[1]["file"]), (200, file.name))
        second = put("a: 2\n", first[1]["checksum"])
        self.assertEqual((second[0], file.read_text(encoding="utf-8")), (200, "a: 2\n"))
        for version in (first[1]["checksum"], "", "x"):
            refused = put("a: 3\n", version)
            self.assertEqual((refused[0], refused[1]["checksum"]), (409, second[1]["checksum"]))
            self.assertRegex(refused[1]["errors"][0], r"^shared\.yaml: found another content than the one that this change began with; nothing was written\. ")
        self.assertEqual(put("a: 3\n")[0], 409)
        self.assertEqual(file.read_text(encoding="utf-8"), "a: 2\n")
        self.assertEqual(put("a: 2\n", "")[0], 200)  # the same text is no loss
        self.assertEqual(put("a: 3\n", refused[1]["checksum"])[0], 200)
        self.assertEqual(put("a: 4\n", 5)[0], 422)

    def test_without_a_version_the_one_that_was_read_last_counts(self):
        with tempfile.TemporaryDirectory() as place:
            file = pathlib.Path(place) / "case.yaml"
            file.write_text(ROLLERS, encoding="utf-8")
            with page(file) as running:
                for text in (ROLLERS + "# one\n", ROLLERS + "# two\n"):
                    self.assertEqual(running.post("/save", {"file": "case.yaml", "text": text})[0], 200)
                    opened = running.get("/opened")
                    self.assertEqual((opened["text"], file.read_text(encoding="utf-8")), (text, text))
                with file.open("a", encoding="utf-8") as more:
                    more.write("# of a colleague\n")
                self.assertEqual(running.post("/save", {"file": "case.yaml", "text": ROLLERS})[0], 409)
                self.assertTrue(file.read_text(encoding="utf-8").endswith("# of a colleague\n"))
                self.assertTrue(running.get("/opened")["text"].endswith("# of a colleague\n"))

    def test_files_go_into_the_folder_that_was_opened(self):
        status, saved = self.page.post("/save", {"file": "mine.yaml", "text": ROLLERS})
        self.assertEqual((status, saved["file"]), (200, "mine.yaml"))
        self.assertEqual((self.folder / "mine.yaml").read_text(encoding="utf-8"), ROLLERS)
        outside = self.folder.parent / "outside.yaml"
        (self.folder / "link.yaml").symlink_to(outside)
        for name in ("../outside.yaml", str(outside), "a/b.yaml", "..", ".", "", ".bashrc", ".yaml", "x.sh", "x", "link.yaml", "a\0.yaml", "a\n.yaml",
                     "x" * 300 + ".yaml", "..\\outside.yaml"):
            with self.subTest(name=name):
                status, answer = self.page.post("/save", {"file": name, "text": "x"})
                self.assertEqual((status, answer["code"]), (422, 2))
        self.assertFalse(outside.exists())
        for body in ({"file": "a.yaml"}, {"file": "a.yaml", "text": 3}, {"file": "a.yaml", "text": "", "mode": 7}, []):
            self.assertEqual(self.page.post("/save", body)[0], 422)

    def test_without_a_folder_nothing_is_written(self):
        with page("duplex") as running:
            self.assertFalse(running.get("/opened")["writable"])
            self.assertEqual(running.post("/save", {"file": "a.yaml", "text": "x"})[0], 409)


class Computations(Shared):
    """Item 2: progress, points as they end, stop and continue."""

    def test_points_and_result_of_a_sweep(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.yaml"
            file.write_text(TEMPLATE, encoding="utf-8")
            expected = json.loads(run("sweep", file, "--json", "--set", BRIEF[0]).stdout)
        events = list(self.page.events(self.page.start("sweep", TEMPLATE, BRIEF)))
        points = [data for name, data in events if name == "point"]
        self.assertEqual(events[-1][0], "result")
        self.assertEqual(events[-1][1], expected)
        key = lambda row: row["input_speed_rpm"]  # noqa: E731
        self.assertEqual(sorted(points, key=key), sorted(expected["points"], key=key))
        for name, data in events:
            if name == "progress":
                self.assertEqual(set(data), {"done", "all", "doing", "seconds_left"})
                self.assertLessEqual(data["done"], data["all"])

    def test_mistakes_of_a_job(self):
        events = list(self.page.events(self.page.start("run", ROLLERS.replace("radial: 8 kN", "radial: 8 mm"))))
        self.assertEqual([name for name, _ in events], ["failed"])
        self.assertEqual(events[0][1]["code"], 2)
        self.assertRegex(events[0][1]["errors"][0], r"^case\.yaml:\d+:\d+: load\.radial: ")

    def test_stopped_and_continued(self):
        sweep = FOUR_SPEEDS
        job = self.page.start("sweep", TEMPLATE, sweep, SLOW)
        seen = []
        for name, data in self.page.events(job):
            seen.append((name, data))
            if name == "point" and sum(one == "point" for one, _ in seen) == 1:
                self.assertEqual(self.page.ask("DELETE", f"/jobs/{job}")[0], 200)
        self.assertEqual(seen[-1][0], "stopped")
        kept = seen[-1][1]["points"]
        self.assertTrue(1 <= len(kept) < 4, len(kept))
        self.assertEqual(kept, [data for name, data in seen if name == "point"])
        # A reader that comes back gets what it has not seen, one that comes late all of it.
        self.assertEqual([data for name, data in self.page.events(job) if name == "point"], kept)
        self.assertEqual([name for name, _ in self.page.events(job, last="1")], [name for name, _ in seen if name not in ("progress", "motion")][1:])
        events = list(self.page.events(self.page.start("sweep", TEMPLATE, sweep, SLOW, **{"continue": job})))
        self.assertEqual(events[-1][0], "result", events[-1])
        points = [data for name, data in events if name == "point"]
        self.assertEqual(points[:len(kept)], kept)
        self.assertEqual(len(points), 4)
        whole = events[-1][1]
        again = list(self.page.events(self.page.start("sweep", TEMPLATE, sweep, SLOW)))[-1][1]
        self.assertEqual(whole, again)  # to the last bit, as if it had not been stopped
        other = list(self.page.events(self.page.start("sweep", TEMPLATE, [*sweep, "input.power=90 kW"], SLOW, **{"continue": job})))
        self.assertEqual((other[-1][0], other[-1][1]["code"]), ("failed", 2))

    def test_a_job_that_is_not_there(self):
        self.refused(404, "GET", "/jobs/9999/events")
        self.refused(404, "DELETE", "/jobs/9999")
        for name in ("9999", 3, None, "../0001"):
            self.assertEqual(self.page.post("/jobs", {"command": "sweep", "case_text": TEMPLATE, "continue": name})[0], 422)

    def test_jobs_at_once_are_bounded(self):
        long = ("sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 10 rpm}",)
        jobs, refused = [], 0
        for _ in range(12):
            status, answer = self.page.post("/jobs", {"command": "sweep", "case_text": TEMPLATE, "settings": long, "options": SLOW})
            jobs += [answer["job"]] if status == 202 else []
            refused += status == 429
        self.assertEqual((len(jobs), refused), (8, 4))
        for job in jobs:
            self.page.ask("DELETE", f"/jobs/{job}")
        for job in jobs:
            self.assertEqual(list(self.page.events(job))[-1][0], "stopped")

    def test_a_reader_that_is_cut_off_does_not_end_the_job(self):
        job = self.page.start("sweep", TEMPLATE, BRIEF)
        for _ in range(3):
            with contextlib.closing(socket.create_connection(("127.0.0.1", self.page.port))) as raw:
                raw.sendall((f"GET /jobs/{job}/events?token={self.page.token} HTTP/1.1\r\nHost: 127.0.0.1:{self.page.port}\r\n\r\n").encode())
                raw.recv(10)
        self.assertEqual(list(self.page.events(job))[-1][0], "result")


class Reports(Shared):
    """Items 4 and 6: the report of a case as the page asks for it."""

    def test_a_bearing_as_a_page_and_as_pdf(self):
        case = {"case_text": ROLLERS, "settings": ["load.radial=9 kN"]}
        status, headers, data = self.page.ask("POST", "/report", case)
        self.assertEqual((status, headers["Content-Type"]), (200, "text/plain; charset=utf-8"), data[:300])
        self.assertTrue(data.startswith(b"<!DOCTYPE html>"))
        status, headers, data = self.page.ask("POST", "/report?form=pdf", case)
        if importlib.util.find_spec("weasyprint") is None:
            self.assertEqual(status, 500)
            self.assertIn("weasyprint", json.loads(data)["errors"][0])
            return
        self.assertEqual((status, headers["Content-Type"]), (200, "application/pdf"), data[:300])
        self.assertTrue(data.startswith(b"%PDF-"))
        if shutil.which("pdftotext"):
            text = subprocess.run(["pdftotext", "-", "-"], input=data, capture_output=True, check=True).stdout.decode()
            self.assertIn("roller_bearing", text)

    def test_a_report_of_the_point_and_of_the_speeds(self):
        """The same case: of=point has its one speed, of=speeds those of its sweep; without of the latter."""
        case = {"case_text": pathlib.Path(REDUCER).read_text(encoding="utf-8"), "settings": ["input.speed=5123 rpm", "sweep.input.speed=[4321 rpm, 7654 rpm]"]}
        shown = {}
        for of in ("point", "speeds", ""):
            status, _, data = self.page.ask("POST", f"/report?of={of}" if of else "/report", case)
            self.assertEqual(status, 200, data[:300])
            shown[of] = data.decode()
        for of, there, not_there in (("point", "5,123 rpm", "7,654"), ("speeds", "7,654", ""), ("", "7,654", "")):
            self.assertIn(there, shown[of], of)
            if not_there:
                self.assertNotIn(not_there, shown[of], of)

    def test_what_has_no_report(self):
        wrong = self.page.post("/report?form=pdf", {"case_text": ROLLERS.replace("radial: 8 kN", "radial: 8 mm")})
        self.assertEqual((wrong[0], wrong[1]["code"]), (422, 2))
        self.assertRegex(wrong[1]["errors"][0], r"^case\.yaml:\d+:\d+: load\.radial: ")
        self.assertEqual(self.page.post("/report?form=pdf", {"job": "9999"})[0], 404)
        self.assertEqual(self.page.post("/report?of=all", {"case_text": ROLLERS})[0], 400)


class Results(unittest.TestCase):
    """Item 6: folders of results open too."""

    def test_a_folder_whose_case_is_not_the_one_that_was_run(self):
        """Lives of 150 kW do not stand beside a case of 300 kW: refused as `report` refuses it."""
        with tempfile.TemporaryDirectory() as place:
            file, folder = pathlib.Path(place) / "case.yaml", pathlib.Path(place) / "results"
            file.write_text(TEMPLATE, encoding="utf-8")
            done = run("sweep", file, "-o", folder, "--grid-only", "--quiet", "--set", BRIEF[0])
            self.assertEqual(done.returncode, 0, done.stderr)
            resolved = folder / "case.resolved.yaml"
            sound = resolved.read_text(encoding="utf-8")
            other = sound.replace("160 kW", "320 kW")
            self.assertNotEqual(sound, other)
            said = f"{resolved}: differs from what its run wrote; required: an undamaged result. Give its command again with --resume, or into another folder"
            with page(folder) as running, page(file) as beside:
                resolved.write_text(other, encoding="utf-8")
                opened = running.get("/opened")
                self.assertEqual((opened["text"], opened["error"]), (other, said))
                self.assertFalse({"points", "result", "finished"} & set(opened))
                status, answer = beside.post("/jobs", {"command": "sweep", "case_text": TEMPLATE, "results": "results"})
                self.assertEqual((status, answer["errors"]), (422, [said]))
                status, _, data = beside.ask("GET", "/opened?results=results")
                self.assertEqual((status, json.loads(data)["errors"]), (422, [said]))
                for command in (("open", "--no-browser", folder), ("report", folder, "--quiet")):
                    refused = run(*command)
                    self.assertEqual((refused.returncode, refused.stderr.strip()), (2, said), command)
                resolved.write_text(sound, encoding="utf-8")
                self.assertEqual(len(running.get("/opened")["points"]), 3)

    def test_folders(self):
        with tempfile.TemporaryDirectory() as place:
            file, folder = pathlib.Path(place) / "case.yaml", pathlib.Path(place) / "results"
            file.write_text(TEMPLATE, encoding="utf-8")
            printed = json.loads(run("sweep", file, "-o", folder, "--json", "--set", BRIEF[0]).stdout)
            with page(folder) as running:
                opened = running.get("/opened")
                self.assertEqual((opened["kind"], opened["name"], opened["finished"], opened["fidelity"]),
                                 ("results", "results", True, "quasi-static"))
                self.assertEqual(opened["text"], (folder / "case.resolved.yaml").read_text(encoding="utf-8"))
                self.assertEqual(opened["points"], printed["points"])
                self.assertEqual({**opened["result"], "units": None}, {**printed, "units": None})
                self.assertEqual(opened["result"]["units"], printed["units"])
                for name in ("sweep.csv", "case.resolved.yaml"):
                    self.assertEqual(running.post("/save", {"file": name, "text": "x"})[0], 422)
                self.assertEqual(running.post("/save", {"file": "own.yaml", "text": "x"})[0], 200)
                lines = (folder / "manifest.jsonl").read_text(encoding="utf-8").splitlines(keepends=True)
                (folder / "manifest.jsonl").write_text("".join(lines[:-2]), encoding="utf-8")
                opened = running.get("/opened")  # as one that is still computed
                self.assertFalse(opened["finished"])
                self.assertEqual(len(opened["points"]), len(lines) - 3)
                self.assertNotIn("result", opened)

    def test_a_crowning_study(self):
        with tempfile.TemporaryDirectory() as place:
            file, folder = pathlib.Path(place) / "case.yaml", pathlib.Path(place) / "results"
            file.write_text(TEMPLATE, encoding="utf-8")
            done = run("crown", file, "-o", folder, "--json", "--drops", "0 um, 4 um, 8 um", "--starts", "1")
            self.assertEqual(done.returncode, 0, done.stderr)
            with page(folder) as running:
                opened = running.get("/opened")
                self.assertEqual((opened["finished"], opened["result"]), (True, json.loads(done.stdout)))


class Command(unittest.TestCase):
    def test_kinds_of_what_is_opened(self):
        with tempfile.TemporaryDirectory() as place:
            (pathlib.Path(place) / "case.yaml").write_text(ROLLERS, encoding="utf-8")
            for what, kind, writable in (([], "start", False), (["roller-bearing"], "template", False), ([place], "case", True),
                                         ([REDUCER], "case", True)):
                with page(*what) as running:
                    opened = running.get("/opened")
                    self.assertEqual((opened["kind"], opened["writable"]), (kind, writable))
                    if kind != "start":
                        self.assertTrue(lives_in(running.ask("GET", "/")[2].decode()))

    def test_what_cannot_be_opened_is_refused(self):
        with tempfile.TemporaryDirectory() as place:
            for what in ("nothing", place, place + "/none.yaml"):
                refused = run("open", "--no-browser", what)
                self.assertEqual((refused.returncode, refused.stdout), (2, ""), refused.stderr)
                self.assertIn("; required: ", refused.stderr)

    def test_each_option_of_a_job_is_one_of_the_program(self):
        with page("duplex") as running:
            for command in ("run", "sweep", "crown", "modes", "sensitivities", "signals", "validate"):
                with self.subTest(command=command):
                    asked = {"command": command, "options": {"nonsense": 1}, **({} if command == "validate" else {"case_text": ROLLERS})}
                    status, _, data = running.ask("POST", "/jobs", asked)
                    names = re.search(r"cannot give to \w+; required: one of ([\w, ]+)", data.decode())[1].split(", ")
                    options = re.findall(r"--([a-z-]+)", run(command, "--help").stdout)
                    self.assertEqual((status, len(names)), (422, len(set(names))))
                    self.assertEqual({name.replace("_", "-") for name in names} - set(options), set())
                    self.assertEqual("jobs" in names, "jobs" in options)

    def test_a_port_that_is_taken(self):
        with page("duplex") as running:
            refused = run("open", "--no-browser", "--port", running.port)
            self.assertEqual((refused.returncode, refused.stdout), (1, ""))
            self.assertEqual(refused.stderr, f"--port: {running.port} is taken or may not be used; give another one, or none for a free one\n")
            status = running.ask("GET", "/opened")[0]
            self.assertEqual(status, 200)

    def test_signals_end_it(self):
        for which in (signal.SIGINT, signal.SIGTERM):
            with page("duplex") as running:
                running.ask("GET", "/")
                self.assertEqual(running.end(which), (0, "", ""))

    def kept_folder(self, running):
        """Of results, as the program names it at its end."""
        said = running.process.stdout.read()
        folder = pathlib.Path(re.search(r"results are kept in (\S+);", said).group(1))
        self.addCleanup(shutil.rmtree, folder.parent)
        return folder

    def test_it_ends_after_the_last_page_and_keeps_results(self):
        """Item 5: when the page is closed, the program ends after a minute (here 2 s), results kept and whole."""
        with page("--linger", "2") as running:
            time.sleep(2.5)
            self.assertTrue(running.lives())  # no page was there yet
            points = list(running.events(running.start("sweep", TEMPLATE, [*BRIEF], {"grid_only": True})))[-1][1]["points"]
            for name in ("one", "other"):
                running.post(f"/alive?page={name}", "{}")
            running.post("/closed?page=one", "{}")
            time.sleep(3)
            self.assertTrue(running.lives())  # the other page is there, though it says nothing
            running.post("/closed?page=other", "{}")
            self.assertEqual(running.process.wait(timeout=20), 0)
            folder = self.kept_folder(running)
        self.assertTrue((folder / "sweep.csv").exists())
        with page(folder) as running:
            opened = running.get("/opened")
        self.assertEqual((opened["finished"], opened["points"]), (True, points))

    def test_it_ends_where_a_page_falls_silent(self):
        """A browser that was killed closes no page: after three times as long the program ends too."""
        with page("--linger", "2") as running:
            running.post("/alive?page=lost", "{}")
            with self.assertRaises(subprocess.TimeoutExpired):  # not yet: it ends after 6 s
                running.process.wait(timeout=2.5)
            self.assertEqual(running.process.wait(timeout=60), 0)

    def test_results_are_whole_where_it_is_ended(self):
        """Points of a sweep that runs as the program ends are kept, and the command line goes on with them."""
        with page("e-drive") as running:
            job = running.start("sweep", TEMPLATE, FOUR_SPEEDS, SLOW)
            first = next(data for name, data in running.events(job) if name == "point")
            running.process.send_signal(signal.SIGTERM)
            self.assertEqual(running.process.wait(timeout=60), 0)
            folder = self.kept_folder(running)
        with page(folder) as running:
            opened = running.get("/opened")
        self.assertIn(first, opened["points"])
        self.assertNotIn("error", opened)

    def test_its_processes_end_with_it(self):
        with page("e-drive") as running:
            running.ask("GET", "/")
            children = subprocess.run(["ps", "-o", "pid=", "--ppid", str(running.process.pid)], capture_output=True, text=True, check=False).stdout.split()
            self.assertTrue(children)
            running.process.kill()
            running.process.wait()
            until = time.monotonic() + 10
            while time.monotonic() < until and any(os.path.exists(f"/proc/{child}/exe") for child in children):
                time.sleep(0.1)
            self.assertFalse([child for child in children if os.path.exists(f"/proc/{child}/exe")])


class FromPython(unittest.TestCase):
    """Item 2: orbearing.open(case)."""

    def test_a_case_with_its_changes_is_opened(self):
        orbearing = package()
        case = orbearing.load(CASES / "templates" / "roller-bearing.yaml")
        case["load.radial"] = "9 kN"
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed), orbearing.open(case, browser=False) as running:
            with urllib.request.urlopen(running.address, timeout=60) as document:
                lives = lives_in(document.read().decode())
            self.assertEqual(lives["L10mrh"], round(case.run()["L10mrh"]))
            save = urllib.request.Request(running.address.replace("/?", "/save?"), json.dumps({"file": "mine.yaml", "text": ROLLERS}).encode())
            urllib.request.urlopen(save, timeout=60).close()
        folder = pathlib.Path(re.fullmatch(r"saved files are kept in (\S+)\n", printed.getvalue()).group(1))
        self.addCleanup(shutil.rmtree, folder)
        self.assertEqual((folder / "mine.yaml").read_text(encoding="utf-8"), ROLLERS)
        with contextlib.redirect_stdout(printed), orbearing.open(case, browser=False) as running:
            running.close()  # once more behind it
        self.assertEqual(printed.getvalue().count("\n"), 1)
        with self.assertRaisesRegex(orbearing.CaseError, "found no such file, folder or template"):
            orbearing.open("nothing", browser=False)


if __name__ == "__main__":
    faulthandler.dump_traceback_later(300, exit=True)  # where it waits, should it not end
    unittest.main()
