#!/usr/bin/env python3
"""check_circles.py ROOT: prints each circle of includes between folders and between header-and-source
pairs, and of imports between modules of the Python package, with what makes it, and fails where there is one.

A folder stands for the files directly in it; a folder within it stands for itself, so bearing/ may know
bearing/profile/ as long as bearing/profile/ does not know bearing/. x.hpp and x.cpp are one pair. Only
includes written from the root count, which is how CheckArchitecture.cmake wants them."""

import ast
import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
SUFFIXES = {".hpp", ".cpp"}
FOLDERS = ["mechanics", "gearset", "bearing", "coupling", "page", "app"]


def includes(root):
    """(including file, included file) of every include of a file that is there."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES or not path.is_file():
                continue
            for header in INCLUDE.findall(path.read_text(encoding="utf-8")):
                if (root / header).is_file():
                    yield path.relative_to(root), pathlib.PurePath(header)


def imports(root):
    """The same of the modules of the Python package, imports within functions and for types alone among them."""
    package = root / "python"

    def file_of(name):
        module = package / name.replace(".", "/")
        return next((file for file in (module.with_suffix(".py"), module / "__init__.py") if file.is_file()), None)

    for path in sorted(package.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            found = []
            if isinstance(node, ast.Import):
                found = [file_of(alias.name) for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and node.module:  # of a module, or of what it holds
                found = [file_of(f"{node.module}.{alias.name}") or file_of(node.module) for alias in node.names]
            for file in filter(None, found):
                if file != path:
                    yield path.relative_to(root), pathlib.PurePath(file.relative_to(root))


def graph_of(edges, node):
    """node -> node -> the includes or imports between them."""
    graph = collections.defaultdict(lambda: collections.defaultdict(list))
    for source, target in edges:
        if node(source) != node(target):
            graph[node(source)][node(target)].append(f"{source} includes {target}")
    return graph


def reached_from(graph, start):
    reached, waiting = set(), [start]
    while waiting:
        for target in graph.get(waiting.pop(), {}):
            if target not in reached:
                reached.add(target)
                waiting.append(target)
    return reached


def shortest_circle(graph, start):
    """The nodes of a shortest way from start back to it."""
    before, waiting = {}, collections.deque([start])
    while waiting:
        here = waiting.popleft()
        for target in sorted(graph.get(here, {})):
            if target == start:
                way = [here]
                while way[-1] != start:
                    way.append(before[way[-1]])
                return way[::-1] + [start]
            if target not in before:
                before[target] = here
                waiting.append(target)
    raise ValueError(f"no way from {start} back to it")


def circles(graph):
    """One shortest circle through every node that lies on one, each circle once."""
    found = {}
    for node in sorted(graph):
        if node in reached_from(graph, node):
            circle = shortest_circle(graph, node)
            found.setdefault(frozenset(circle), circle)
    return list(found.values())


def report(graph, kind):
    """Prints the circles; how many there are."""
    found = circles(graph)
    for circle in found:
        print(f"circle of {kind}: {' -> '.join(circle)}")
        for source, target in zip(circle, circle[1:]):
            for line in graph[source][target]:
                print(f"  {line}")
    return len(found)


def main():
    edges = list(includes(pathlib.Path(sys.argv[1])))
    count = report(graph_of(edges, lambda path: str(path.parent)), "folders")
    count += report(graph_of(edges, lambda path: str(path.with_suffix(""))), "pairs")
    count += report(graph_of(imports(pathlib.Path(sys.argv[1])), str), "modules")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
