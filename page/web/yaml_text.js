// Case files as text: a tree with the place of each value in the text, and edits that leave all else,
// comments too, as it was.
//
// Read are block and flow mappings and lists, plain and quoted scalars and block scalars, which is what case
// files hold. Anchors, aliases, tags and several documents are refused: such a text is edited as text alone.
// The program judges the case.

export class NotReadable extends Error {}

const isBlank = (line) => /^\s*(#.*)?$/.test(line);
const indentOf = (line) => line.length - line.trimStart().length;

class Reader {
  constructor(text) {
    this.text = text;
    this.lines = [];
    let from = 0;
    for (const line of text.split('\n')) {
      this.lines.push(
          {start: from, text: line.replace(/\r$/, ''), end: from + line.replace(/\r$/, '').length});
      from += line.length + 1;
    }
    this.at = 0;
  }

  refuse(what, offset) {
    throw new NotReadable(`line ${this.text.slice(0, offset).split('\n').length}: ${what}`);
  }

  skipBlank() {
    while (this.at < this.lines.length && isBlank(this.lines[this.at].text)) this.at++;
    return this.lines[this.at];
  }

  document() {
    if (this.skipBlank()?.text.trim() === '---') this.at++;
    const first = this.skipBlank();
    if (!first)
      return {
        kind: 'map',
        flow: false,
        entries: [],
        indent: 0,
        start: this.text.length,
        end: this.text.length
      };
    const node = this.block(indentOf(first.text), 0);
    const left = this.skipBlank();
    if (left) this.refuse('its indentation belongs to no mapping above', left.start);
    return node;
  }

  block(indent, column) {
    const line = this.lines[this.at], body = line.text.slice(column || indent);
    if (line.text.slice(0, indent).includes('\t'))
      this.refuse('a tabulator indents it; blanks are required', line.start);
    if (/^-(\s|$)/.test(body)) return this.blockList(indent);
    if (this.keyAt(line.start + indent, line)) return this.blockMap(indent);
    return this.value(line.start + indent, indent - 1);
  }

  // A key and the place behind its colon; null where the line has none.
  keyAt(offset, line) {
    const rest = this.text.slice(offset, line.end);
    const quoted = /^("(?:[^"\\]|\\.)*"|'(?:[^']|'')*')\s*:(?=\s|$)/.exec(rest);
    if (quoted)
      return {
        key: scalarOf(quoted[1]),
        keyStart: offset,
        keyEnd: offset + quoted[1].length,
        after: offset + quoted[0].length
      };
    const plain = /^([^\s#&*!|>'"%@`{}[\],?-][^#]*?|-[^\s#][^#]*?)\s*:(?=\s|$)/.exec(rest);
    if (!plain) return null;
    return {
      key: plain[1],
      keyStart: offset,
      keyEnd: offset + plain[1].length,
      after: offset + plain[0].length
    };
  }

  blockMap(indent) {
    const node = {kind: 'map', flow: false, entries: [], indent, start: this.lines[this.at].start + indent};
    for (let line = this.skipBlank(), first = true; line && (first || indentOf(line.text) === indent);
         line = this.skipBlank(), first = false) {
      const key = this.keyAt(line.start + indent, line);
      if (!key) {
        if (/^-(\s|$)/.test(line.text.slice(indent))) break;
        this.refuse('a key and a colon are required', line.start + indent);
      }
      const entry = {...key, line: this.at};
      entry.node = this.entryValue(key.after, indent);
      entry.lastLine = this.at - 1;
      node.entries.push(entry);
      node.end = entry.node.end;
    }
    return node;
  }

  entryValue(after, indent) {
    const line = this.lines[this.at], rest = this.text.slice(after, line.end);
    if (!isBlank(rest)) return this.value(after + rest.length - rest.trimStart().length, indent);
    this.at++;
    const kept = this.at, next = this.skipBlank();
    const deeper = next &&
        (indentOf(next.text) > indent ||
         (indentOf(next.text) === indent && /^-(\s|$)/.test(next.text.slice(indent))));
    if (deeper) return this.block(indentOf(next.text), 0);
    this.at = kept;
    return {kind: 'scalar', value: null, empty: true, start: after, end: after};
  }

  blockList(indent) {
    const node = {kind: 'list', flow: false, items: [], indent, start: this.lines[this.at].start + indent};
    for (let line = this.skipBlank();
         line && indentOf(line.text) === indent && /^-(\s|$)/.test(line.text.slice(indent));
         line = this.skipBlank()) {
      const rest = line.text.slice(indent + 1), inner = indent + 1 + rest.length - rest.trimStart().length;
      let item;
      if (isBlank(rest)) {
        this.at++;
        const next = this.skipBlank();
        item = next && indentOf(next.text) > indent ?
            this.block(indentOf(next.text), 0) :
            {kind: 'scalar', value: null, empty: true, start: line.end, end: line.end};
      } else if (/^-(\s|$)/.test(line.text.slice(inner)) || this.keyAt(line.start + inner, line)) {
        // The first key, or item of a list within, stands behind the dash; the others stand below it.
        const kept = line.text;
        line.text = ' '.repeat(inner) + kept.slice(inner);
        item = this.block(inner, 0);
        line.text = kept;
      } else
        item = this.value(line.start + inner, indent);
      node.items.push(item);
      node.end = item.end;
    }
    return node;
  }

  // A value that begins at `offset` in the present line, below a parent indented by `indent`; afterwards the
  // reader is behind its last line.
  value(offset, indent) {
    const first = this.text[offset];
    if ('&*!'.includes(first)) this.refuse('anchors, aliases and tags are not read here', offset);
    if (first === '{' || first === '[') {
      const node = this.flow(offset);
      return this.endOfLine(node);
    }
    if (first === '|' || first === '>') return this.blockScalar(offset, indent);
    if (first === '"' || first === '\'') {
      const end = quotedEnd(this.text, offset);
      if (end < 0) this.refuse('a quotation mark is not closed', offset);
      return this.endOfLine(
          {kind: 'scalar', value: scalarOf(this.text.slice(offset, end)), start: offset, end});
    }
    const line = this.lines[this.at],
          plain = this.text.slice(offset, line.end).replace(/\s+#.*$/, '').trimEnd();
    const node = {kind: 'scalar', value: plain, start: offset, end: offset + plain.length};
    if (/:(\s|$)/.test(plain)) this.refuse('a colon within a value', offset);
    this.at++;
    for (let next = this.lines[this.at]; next && !isBlank(next.text) && indentOf(next.text) > indent;
         next = this.lines[this.at]) {
      if (this.keyAt(next.start + indentOf(next.text), next))
        this.refuse('its indentation belongs to no mapping above', next.start);
      const more = next.text.replace(/\s+#.*$/, '').trim();
      node.value += ` ${more}`;
      node.end = next.start + indentOf(next.text) + more.length;
      this.at++;
    }
    return node;
  }

  endOfLine(node) {
    while (this.lines[this.at].end < node.end) this.at++;
    const rest = this.text.slice(node.end, this.lines[this.at].end);
    if (!isBlank(rest)) this.refuse('nothing but a comment may follow', node.end);
    this.at++;
    return node;
  }

  blockScalar(offset, indent) {
    const folded = this.text[offset] === '>', parts = [];
    let end = this.lines[this.at].end;
    this.at++;
    while (this.at < this.lines.length &&
           (this.lines[this.at].text.trim() === '' || indentOf(this.lines[this.at].text) > indent)) {
      parts.push(this.lines[this.at].text);
      if (this.lines[this.at].text.trim()) end = this.lines[this.at].end;
      this.at++;
    }
    const own = Math.min(...parts.filter((part) => part.trim()).map(indentOf));
    const value = parts.map((part) => part.slice(own)).join(folded ? ' ' : '\n').trimEnd();
    return {kind: 'scalar', value, start: offset, end};
  }

  skipFlowSpace(offset) {
    for (;;) {
      while (/\s/.test(this.text[offset] ?? '')) offset++;
      if (this.text[offset] !== '#') return offset;
      while (offset < this.text.length && this.text[offset] !== '\n') offset++;
    }
  }

  flow(offset) {
    const open = this.text[offset];
    if (open === '{' || open === '[') {
      const map = open === '{',
            node = {kind: map ? 'map' : 'list', flow: true, entries: [], items: [], start: offset};
      offset = this.skipFlowSpace(offset + 1);
      while (this.text[offset] !== (map ? '}' : ']')) {
        if (offset >= this.text.length) this.refuse(`'${open}' is not closed`, node.start);
        const part = map ? this.flowEntry(offset) : {node: this.flow(offset)};
        (map ? node.entries : node.items).push(map ? part : part.node);
        offset = this.skipFlowSpace(part.node.end);
        if (this.text[offset] === ',')
          offset = this.skipFlowSpace(offset + 1);
        else if (offset < this.text.length && this.text[offset] !== (map ? '}' : ']'))
          this.refuse('a comma is required between entries', offset);
      }
      node.end = offset + 1;
      return node;
    }
    return this.flowScalar(offset, /[,{}[\]]/);
  }

  flowScalar(offset, stop) {
    const first = this.text[offset];
    if ('&*!'.includes(first)) this.refuse('anchors, aliases and tags are not read here', offset);
    if (first === '"' || first === '\'') {
      const end = quotedEnd(this.text, offset);
      if (end < 0) this.refuse('a quotation mark is not closed', offset);
      return {kind: 'scalar', value: scalarOf(this.text.slice(offset, end)), start: offset, end};
    }
    let end = offset;
    while (end < this.text.length && !stop.test(this.text[end]) && this.text[end] !== '\n' &&
           !(this.text[end] === ':' && /[\s,}\]]/.test(this.text[end + 1] ?? '\n')))
      end++;
    const plain = this.text.slice(offset, end).trimEnd();
    if (!plain) this.refuse('a value is required', offset);
    return {kind: 'scalar', value: plain, start: offset, end: offset + plain.length};
  }

  flowEntry(offset) {
    const key = this.flowScalar(offset, /[,{}[\]]/), colon = this.skipFlowSpace(key.end);
    if (this.text[colon] !== ':') this.refuse('a colon is required behind a key', colon);
    const from = this.skipFlowSpace(colon + 1);
    const none = ',}'.includes(this.text[from]);
    const node =
        none ? {kind: 'scalar', value: null, empty: true, start: colon + 1, end: colon + 1} : this.flow(from);
    return {key: key.value, keyStart: key.start, keyEnd: key.end, after: colon + 1, node};
  }
}

function quotedEnd(text, offset) {
  const mark = text[offset];
  for (let i = offset + 1; i < text.length; i++) {
    if (mark === '"' && text[i] === '\\')
      i++;
    else if (text[i] === mark) {
      if (mark === '\'' && text[i + 1] === '\'')
        i++;
      else
        return i + 1;
    }
  }
  return -1;
}

const escapes = {
  n: '\n',
  t: '\t',
  r: '\r',
  0: '\0',
  b: '\b',
  f: '\f',
  e: '\x1b'
};

function scalarOf(source) {
  const inner = source.slice(1, -1);
  if (source[0] === '\'') return inner.replace(/''/g, '\'');
  return inner.replace(
      /\\(x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|.)/gs,
      (all, one) => one.length > 1 ? String.fromCharCode(parseInt(one.slice(1), 16)) : (escapes[one] ?? one));
}

/** The tree of a text. Throws NotReadable. */
export const parse = (text) => new Reader(text).document();

const entryOf = (node, key) =>
    (node?.kind === 'map' ? node.entries.find((entry) => entry.key === key) : undefined);

/** The node at a path (a list of keys); undefined where there is none. */
export function nodeAt(tree, path) {
  let node = tree;
  for (const key of path) node = entryOf(node, key)?.node;
  return node;
}

/**
 * The value at a path as text: a scalar's own, a list or mapping as it stands in the text, without its
 * indentation.
 */
export function textAt(text, node) {
  if (!node || node.empty) return '';
  if (node.kind === 'scalar') return node.value;
  const source = text.slice(node.start, node.end);
  return node.flow ?
      source :
      source.split('\n')
          .map((line, i) => (i && !line.slice(0, node.indent).trim() ? line.slice(node.indent) : line))
          .join('\n');
}

const needsQuotes = (value) => value === '' || value !== value.trim() ||
    /^[-?:,[\]{}#&*!|>'"%@`]/.test(value) && !/^-?[.\d]/.test(value) && !/^-\S/.test(value) ||
    /:(\s|$)|\s#|[\n\r\t\0-\x1f]/.test(value) || /^(null|~|yes|no|on|off)$/i.test(value);

/**
 * A scalar as YAML, quoted where it must be. `words`: a text that must stay one, though it looks like a
 * number or a switch.
 */
export function scalarText(value, {flow = false, words = false} = {}) {
  const like =
      words && /^(true|false|[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?|0x[\da-f]+|\.inf|\.nan)$/i.test(value);
  if (!needsQuotes(value) && !like && !(flow && /[,{}[\]]/.test(value))) return value;
  return `"${
      value.replace(/["\\]/g, '\\$&')
          .replace(
              /[\0-\x1f]/g,
              (c) =>
                  (c === '\n'     ? '\\n' :
                       c === '\t' ? '\\t' :
                                    `\\x${c.charCodeAt(0).toString(16).padStart(2, '0')}`))}"`;
}

const spliced = (text, from, to, source) => text.slice(0, from) + source + text.slice(to);
const indented = (source, by) =>
    source.split('\n').map((line, i) => (i && line ? ' '.repeat(by) + line : line)).join('\n');

// Below a key indented by `indent`: behind its colon in a line of its own, or as a block in the lines below.
const behindColon = (source, indent) =>
    (source.includes('\n') ? `\n${' '.repeat(indent + 2)}${indented(source, indent + 2)}` : ` ${source}`);

function nested(path, source, indent) {
  if (!path.length) return behindColon(source, indent - 2);
  return `\n${' '.repeat(indent)}${scalarText(path[0])}:${nested(path.slice(1), source, indent + 2)}`;
}

const flowNested = (path, source) =>
    (path.length ? `{${scalarText(path[0], {flow: true})}: ${flowNested(path.slice(1), source)}}` : source);

function added(text, tree, node, path, source, order) {
  if (node.flow) {
    const at = node.end - 1, last = node.entries.at(-1);
    const entry = `${scalarText(path[0], {flow: true})}: ${flowNested(path.slice(1), source)}`;
    return last ? spliced(text, last.node.end, last.node.end, `${last.node.empty ? ' ' : ''}, ${entry}`) :
                  spliced(text, at, at, entry);
  }
  const rank = order ? order.indexOf(path[0]) : -1;
  const before = rank < 0 ?
      node.entries :
      node.entries.filter((entry) => order.indexOf(entry.key) >= 0 && order.indexOf(entry.key) < rank);
  const entry =
      `${' '.repeat(node.indent)}${scalarText(path[0])}:${nested(path.slice(1), source, node.indent + 2)}`;
  const lines = text.split('\n');
  const previous =
      before.length ? before.reduce((one, other) => (other.lastLine > one.lastLine ? other : one)) : null;
  let row = previous      ? lastLineOf(text, previous) + 1 :
      node.entries.length ? node.entries[0].line :
                            lines.length;
  while (row > 0 && !previous && row === lines.length && lines[row - 1] === '') row--;
  lines.splice(row, 0, entry);
  if (row === lines.length - 1) lines.push('');
  return lines.join('\n');
}

const lastLineOf = (text, entry) =>
    text.slice(0, Math.max(entry.node.end, entry.after)).split('\n').length - 1;

/**
 * The text with `source` (YAML) as the value at `path`; mappings that are missing are made. `order`: keys of
 * the schema at the depth where a key is added, in their order.
 */
export function withValue(text, path, source, order) {
  const tree = parse(text);
  let node = tree;
  for (let i = 0; i < path.length; i++) {
    const entry = entryOf(node, path[i]);
    if (!entry) return added(text, tree, node, path.slice(i), source, order?.(path.slice(0, i)));
    const rest = path.slice(i + 1);
    if (!rest.length) return replaced(text, node, entry, source);
    if (entry.node.kind !== 'map')
      return replaced(
          text, node, entry,
          node.flow ? flowNested(rest, source) :
                      nested(rest, source, (node.indent ?? 0) + 2).replace(/^\n */, ''),
          true);
    node = entry.node;
  }
  return text;
}

function replaced(text, parent, entry, source, asBlock = false) {
  const old = entry.node, block = !parent.flow && (asBlock || source.includes('\n'));
  if (!block && (old.flow || old.kind === 'scalar') && !old.empty &&
      !text.slice(entry.after, old.start).includes('\n'))
    return spliced(text, old.start, old.end, source);
  const indent = parent.indent ?? 0;
  return spliced(
      text, entry.after, old.end,
      block ? `\n${' '.repeat(indent + 2)}${indented(source, indent + 2)}` : ` ${source}`);
}

/** The text without the value at `path`; a mapping that held nothing else goes with it. */
export function withoutValue(text, path) {
  const tree = parse(text), chain = [];
  let node = tree;
  for (const key of path) {
    const entry = entryOf(node, key);
    if (!entry) return text;
    chain.push({parent: node, entry});
    node = entry.node;
  }
  let last = chain.length - 1;
  while (last > 0 && chain[last].parent.entries.length === 1) last--;
  const {parent, entry} = chain[last];
  if (parent.flow) {
    const i = parent.entries.indexOf(entry), next = parent.entries[i + 1], previous = parent.entries[i - 1];
    return next ?
        spliced(text, entry.keyStart, next.keyStart, '') :
        spliced(
            text, previous ? previous.node.end : entry.keyStart, Math.max(entry.node.end, entry.after), '');
  }
  const lines = text.split('\n');
  lines.splice(entry.line, lastLineOf(text, entry) - entry.line + 1);
  return lines.join('\n');
}
