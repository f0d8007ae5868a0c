// Elements of the page. Texts of cases and results are only ever set as text, never as markup.

const SVG = 'http://www.w3.org/2000/svg';

function filled(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === undefined || value === null) continue;
    made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

export const element = (name, attributes = {}, ...children) =>
    filled(document.createElement(name), attributes, children);
export const drawn = (name, attributes = {}, ...children) =>
    filled(document.createElementNS(SVG, name), attributes, children);

/**
 * A number for reading: `digits` significant ones, thousands apart by narrow blanks as ISO 80000 has it. The
 * whole number stands in the title.
 */
export function readable(value, digits = 4) {
  if (value === null || value === undefined) return '–';
  if (typeof value !== 'number') return String(value);
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-3) {
    const [mantissa, power] = value.toExponential(digits - 1).split('e');
    return `${mantissa.replace('-', '−')}·10${
            [...String(Number(power))].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('')}`;
  }
  const places = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const [whole, part] = value.toFixed(Math.min(places, 12)).split('.');
  const trimmed = part?.replace(/0+$/, '');
  return (whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') + (trimmed ? `.${trimmed}` : '')).replace('-', '−');
}

const LONG = 6;  // significant digits of an input beyond which it is shortened for reading
const NUMBERS = /\d+\.\d+(?:[eE][-+]?\d+)?|\d+[eE][-+]?\d+/g;
const isQuantities = (text) => /^\s*[-+\d.[{]/.test(text);

/** A quantity of the case, or a list of them, for reading: "5.2399999999999998 mm" as "5.24 mm". */
export function shortened(value) {
  const text = String(value ?? '');
  if (!isQuantities(text)) return text;
  return text.replace(NUMBERS, (number) => {
    const digits = number.replace(/[eE].*/, '').replace('.', '').replace(/^0+/, '').length;
    return digits > LONG ? String(Number(Number(number).toPrecision(LONG))) : number;
  });
}

const UNIT_SIGNS = {
  1: '',
  um: 'µm',
  'N.m': 'N m',
  's-1': 's⁻¹',
  degree: '°',
  deg: '°'
};
export const unitSign = (unit) => UNIT_SIGNS[unit] ?? unit ?? '';

/** A number with its unit, its digits whole in the title and in data-value. */
export function figure(value, unit = '', digits = 4) {
  const sign = unitSign(unit), text = readable(value, digits);
  return element(
      'span', {
        class: 'figure',
        'data-value': value ?? '',
        title: value === null || value === undefined ? 'not computed' :
                                                       `${value} ${unit === '1' ? '' : unit}`.trim()
      },
      value === null || value === undefined || !sign ? text : `${text} ${sign}`);
}

export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  const link = element('a', {href: url, download: name});
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10e3);
}

/** How many there are, in words. */
export const counted = (count, one, many = `${one}s`) => `${count} ${count === 1 ? one : many}`;
export const errorCount = (count) => counted(count, 'error');

/**
 * The path of an input or a name with underscores, which a line may end in behind its dots and underscores.
 */
export const breakable = (text) =>
    String(text).split(/(?<=[._])/).flatMap((part, i) => (i ? [element('wbr'), part] : [part]));
