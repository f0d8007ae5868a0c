"""What the page's server says to requests that it refuses, one line for each mistake; `messages/page.txt` holds the lines."""

import contextlib
import http.client
import json
import pathlib
import sys
import tempfile

from page import page
from program import run

CASE = "name: a\n"
TEMPLATES = pathlib.Path("cases/templates")
REQUESTS = (
    ("/request", []),
    ("/request", {"command": "ls", "shell": 1}),
    ("/request", {"command": "run", "settings": "a", "case_text": 3, "options": []}),
    ("/request", {"command": "run", "options": {"output": "a", "fidelity": {}}}),
    ("/request", {"command": "check", "case_text": CASE, "options": {"output": "a"}}),
    ("/request", {"command": "sweep", "case_text": CASE, "options": {"jobs": 1000}}),
    ("/request", {"command": "validate", "case_text": CASE}),
    ("/request", {"command": "run", "case_text": (TEMPLATES / "e-drive.yaml").read_text(encoding="utf-8"), "settings": ["spectrum={file: ../loads.csv}"]}),
    ("/jobs", {"command": "sweep", "case_text": CASE, "continue": "0001"}),
    ("/request", {"command": "run", "case_text": CASE, "options": {"fidelity": [[[[[[[[1]]]]]]]]}}),
    ("/request", {f"key{i}": 1 for i in range(201)}),
    ("/jobs", {"command": "sweep", "case_text": CASE, "results": "../results"}),
    ("/jobs", {"command": "run", "case_text": CASE, "results": "results"}),
    ("/units", {}),
    ("/units", {"value": "three mm", "unit": "um"}),
    ("/units", {"value": "3 mm", "unit": "N"}),
    ("/save", {"file": "a.sh", "text": ""}),
    ("/save", {"file": "manifest.jsonl.txt"}),
    ("/save", {"file": "case.resolved.yaml", "text": ""}),
)


def told(running, path, body, headers=None):
    status, _, data = running.ask("POST", path, body, headers)
    answer = json.loads(data)
    for line in answer.get("errors", [answer.get("error")]):
        print(f"{status} {line}")


def main():
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place) / "results"
        folder.mkdir()
        (folder / "manifest.jsonl").write_text("", encoding="utf-8")
        (folder / "case.resolved.yaml").write_text(CASE, encoding="utf-8")
        with page(folder) as running:
            for path, body in REQUESTS:
                told(running, path, body)
            told(running, "/save", "x", {"Content-Type": "multipart/form-data; boundary=x"})
            connection = http.client.HTTPConnection("127.0.0.1", running.port, timeout=20)
            with contextlib.closing(connection):
                connection.putrequest("nonsense", "/", skip_host=True)
                connection.endheaders()
                response = connection.getresponse()
                print(response.status, json.loads(response.read())["error"])
            print(run("open", "--no-browser", "--port", running.port).stderr.replace(str(running.port), "PORT"), end="")
            long = {"command": "sweep", "case_text": (TEMPLATES / "e-drive.yaml").read_text(encoding="utf-8"),
                    "settings": ["sweep.input.speed={from: 1000 rpm, to: 12000 rpm, step: 10 rpm}"], "options": {"fidelity": "dynamic", "jobs": 1}}
            for _ in range(8):
                running.start(**long)
            told(running, "/jobs", long)
        (pathlib.Path(place) / "case.yaml").write_text(CASE, encoding="utf-8")
        with page(place) as running:
            told(running, "/save", {"file": "case.yaml", "text": "name: b\n", "checksum": "0"})


sys.exit(main())  # run by messages/page.txt, no test by itself
