"""The server of the page as the tests call it: started, asked over HTTP, ended."""

import contextlib
import http.client
import json
import os
import re
import signal
import subprocess
import urllib.parse


class Page:
    """A running `orbearing open`. `address` is its first line, `port` and `token` are those of it."""

    def __init__(self, *arguments, cwd=None, env=None, stderr=subprocess.PIPE, browser=False):
        words = [] if browser else ["--no-browser"]
        self.process = subprocess.Popen([os.environ["ORBEARING"], "open", *words, *map(str, arguments)], text=True,
                                        stdout=subprocess.PIPE, stderr=stderr, cwd=cwd, env=env)
        self.address = self.process.stdout.readline().strip()
        parts = urllib.parse.urlsplit(self.address)
        self.port, self.token = parts.port, urllib.parse.parse_qs(parts.query).get("token", [""])[0]

    def lives(self):
        return self.process.poll() is None

    def end(self, which=signal.SIGTERM):
        """Returns exit code, further output and messages."""
        if self.lives():
            self.process.send_signal(which)
        said, complained = self.process.communicate(timeout=60)
        return self.process.returncode, said, complained

    def headers(self, more=None):
        return {"X-Orbearing-Token": self.token, **(more or {})}

    def ask(self, method, path, body=None, headers=None, token=True, seconds=120):
        """Status, headers and bytes."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=seconds)
        with contextlib.closing(connection):
            data = json.dumps(body) if isinstance(body, (dict, list)) else body
            connection.request(method, path, data, self.headers(headers) if token else (headers or {}))
            response = connection.getresponse()
            return response.status, dict(response.getheaders()), response.read()

    def get(self, path, **more):
        status, _, data = self.ask("GET", path, **more)
        assert status == 200, (status, data)
        return json.loads(data)

    def post(self, path, body, **more):
        status, _, data = self.ask("POST", path, body, **more)
        return status, json.loads(data)

    def request(self, command, case_text=None, settings=(), **options):
        body = {"command": command, "settings": list(settings), "options": options}
        if case_text is not None:
            body["case_text"] = case_text
        return self.ask("POST", "/request", body)

    def start(self, command, case_text, settings=(), options=None, **more):
        status, answer = self.post("/jobs", {"command": command, "case_text": case_text, "settings": list(settings), "options": options or {}, **more})
        assert status == 202, (status, answer)
        return answer["job"]

    def events(self, job, seconds=300, last=None):
        """(event, object) of each, as they come."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=seconds)
        with contextlib.closing(connection):
            connection.request("GET", f"/jobs/{job}/events", headers=self.headers({"Last-Event-ID": last} if last else {}))
            response = connection.getresponse()
            assert response.status == 200, response.read()
            assert response.getheader("Content-Type") == "text/event-stream"
            name = None
            for line in response:
                text = line.decode().rstrip("\n")
                if text.startswith("event: "):
                    name = text[7:]
                elif text.startswith("data: "):
                    yield name, json.loads(text[6:])


@contextlib.contextmanager
def page(*arguments, **more):
    """A page that is ended behind the block."""
    running = Page(*arguments, **more)
    try:
        yield running
    finally:
        if running.lives():
            running.process.kill()
        running.process.communicate()


def lives_in(document):
    """key -> whole hours, of the table in the document."""
    return {key: int(hours) for key, hours in re.findall(r'<th scope="row">(\w+)</th><td>[^<]*</td><td>(\d+) h</td>', document)}
