"""Sphinx extension: names of documents in `code`, and keys of sources in [brackets], become links.

Documents of the repository name each other as `docs/peak.md` or `bearing/motion/README.md`, from its root or from their own
folder. What looks like such a name and is no document of the site is warned of.
"""

from __future__ import annotations

import posixpath
import re

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
SOURCES = "REFERENCES"
_NAME = re.compile(r"[\w./-]+\.md")
_FOLDER = re.compile(r"[\w.-]+(?:/[\w.-]+)*/?")
_KEY = re.compile(r"\[([A-Z][A-Za-z]*[0-9]{2,}[A-Za-z0-9]*)\]")


def document_of(name: str, docname: str, known) -> str | None:
    """The document that a name in one document means: beside it, from the root, in docs; a folder means its README."""
    for start in (posixpath.dirname(docname), "", "docs"):
        path = posixpath.normpath(posixpath.join(start, name))
        for candidate in ([path[:-3]] if name.endswith(".md") else [path, posixpath.join(path, "README")]):
            if candidate in known:
                return candidate
    return None


class LinksToDocuments(SphinxPostTransform):
    default_priority = 5

    def run(self, **kwargs) -> None:
        docname = self.env.docname
        for literal in list(self.document.findall(nodes.literal)):
            text = literal.astext()
            is_name = _NAME.fullmatch(text)
            if isinstance(literal.parent, (nodes.reference, addnodes.pending_xref)) or not (is_name or "/" in text and _FOLDER.fullmatch(text)):
                continue
            target = document_of(text, docname, self.env.found_docs)
            if target and target != docname:
                literal.replace_self(self._reference(target, "", literal.deepcopy()))
            elif is_name and not target:
                LOGGER.warning("%s is no document of the site", text, location=literal)
        if docname != SOURCES:
            self._link_keys()

    def _reference(self, target: str, anchor: str, shown: nodes.Node) -> nodes.reference:
        address = self.app.builder.get_relative_uri(self.env.docname, target) + anchor
        return nodes.reference("", "", shown, internal=True, refuri=address)

    def _link_keys(self) -> None:
        for text in list(self.document.findall(nodes.Text)):
            if isinstance(text.parent, (nodes.literal, nodes.literal_block, nodes.reference, nodes.title, nodes.raw, addnodes.desc_name)):
                continue
            parts, place = [], 0
            for found in _KEY.finditer(text.astext()):
                if found[1] in self.env.keys_of_sources:
                    parts += [nodes.Text(text.astext()[place:found.start()]), self._reference(SOURCES, f"#{found[1]}", nodes.Text(found[0]))]
                    place = found.end()
            if parts:
                parent, position = text.parent, text.parent.index(text)
                parent.remove(text)
                parent.insert(position, [*parts, nodes.Text(text.astext()[place:])])


def keep_keys(app, doctree) -> None:
    """Each row of the table of sources gets its key as an anchor."""
    if app.env.docname != SOURCES:
        return
    app.env.keys_of_sources = set()
    for row in doctree.findall(nodes.row):
        found = _KEY.fullmatch(row[0].astext())
        if found:
            row["ids"].append(found[1])
            app.env.keys_of_sources.add(found[1])


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app.env, "keys_of_sources", getattr(app.env, "keys_of_sources", set())))
    app.connect("doctree-read", keep_keys)
    app.add_post_transform(LinksToDocuments)
    return {"version": "1", "parallel_read_safe": False, "parallel_write_safe": True}
