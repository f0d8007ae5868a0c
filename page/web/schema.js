// What the schema of case files says of each input: kind, limits, unit, meaning. The form follows from it.

const QUANTITY = /\((?:an?|a list, each element an?) ([a-z -]+?) like '([^']+)'/;
const MANY_EXAMPLES = 10;       // of a text: a catalogue, which is searched by typing
const LINES = /several lines/;  // of a text that may be a table
// A unit begins with no comma: "3,5" is a mistake in the number.
const NUMBER = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*((?:[^\s,.\d].*?)?)\s*$/;

/** "150 kW" -> {number: "150", unit: "kW"}; null where it does not begin with a number. */
export function quantityOf(text) {
  const found = NUMBER.exec(text ?? '');
  return found && {number: found[1], unit: found[2]};
}

const meaningOf = (description = '') =>
    description.replace(/\s*\((?:an?|one of|true or false|a list|a text)\b[^]*$/, '')
        .replace(/; left out:.*$/, '');
const requirementOf = (description = '') =>
    /\(((?:an?|one of|true or false|a list|a text)\b[^]*)$/.exec(description)
        ?.[1]
        .replace(/\)(?=[^)]*$)/, '') ??
    '';

function kindOf(part) {
  if (part.const !== undefined) return 'fixed';
  if (part.enum) return 'choice';
  if (part.type === 'boolean') return 'switch';
  if (part.type === 'integer' || part.type === 'number') return part.type;
  if (part.type === 'string') return QUANTITY.test(part.description ?? '') ? 'quantity' : 'text';
  return 'structure';
}

function fieldOf(path, part, required) {
  const quantity = QUANTITY.exec(part.description ?? '');
  return {
    path,
    key: path.join('.'),
    block: path[0],
    kind: kindOf(part),
    required,
    values: part.enum ?? (part.examples?.length > MANY_EXAMPLES ? part.examples : []),
    lines: LINES.test(part.description ?? ''),
    meaning: meaningOf(part.description),
    requirement: requirementOf(part.description),
    dimension: quantity?.[1] ?? '',
    example: part.examples?.[0] ?? quantity?.[2] ?? '',
    least: part.minimum ?? part.exclusiveMinimum,
    most: part.maximum ?? part.exclusiveMaximum,
    fallback: part.default,
  };
}

const keysAt = (tree) => (tree?.kind === 'map' ? tree.entries.map((entry) => entry.key) : []);
const below = (tree, key) =>
    (tree?.kind === 'map' ? tree.entries.find((entry) => entry.key === key)?.node : undefined);

// Blocks whose keys are those of other inputs: of them only what the case states is an input of the form.
const REPEATS_OTHERS = ['sweep', 'uncertain', 'assumed'];
const SPEED_OF_SWEEP = 'input.speed';

function* walk(part, path, tree, required) {
  const open = Object.entries(part.patternProperties ?? {})
                   .flatMap(
                       ([pattern, one]) => keysAt(tree)
                                               .filter(
                                                   (key) => new RegExp(pattern, 'u').test(key) &&
                                                       !(key in (part.properties ?? {})))
                                               .map((key) => [key, one]));
  for (const [key, one] of [...Object.entries(part.properties ?? {}), ...open]) {
    if (one === true || (path.length === 0 && key === 'assumed')) continue;
    const repeated = REPEATS_OTHERS.includes(path[0]);
    if (repeated && !below(tree, key) && key !== SPEED_OF_SWEEP) continue;
    const inner = one.properties || one.patternProperties;
    // What a part requires counts where the case states the part, or is to state it.
    const counts = below(tree, key) || required.includes(key);
    if (inner && !repeated)
      yield* walk(one, [...path, key], below(tree, key), counts ? (one.required ?? []) : []);
    else
      yield fieldOf([...path, key], one, required.includes(key));
  }
}

// Blocks that a case of several sets has in each of its sets.
const OF_ONE_SET = ['gearset', 'bearing'];

/** Inputs of a model in the order of the schema; of named parts those that the case names. */
export function fieldsOf(schema, model, tree) {
  const part = schema.$defs[model], several = Boolean(below(tree, 'sets'));
  const taken = ({path}) => !several || !OF_ONE_SET.includes(path[0]) || below(tree, path[0]);
  return part?.properties ? [...walk(part, [], tree, part.required ?? [])].filter(taken) : [];
}

/** Keys below a path in the order of the schema. */
export function orderAt(schema, model, path) {
  let part = schema.$defs[model];
  for (const key of path) {
    const open =
        Object.entries(part?.patternProperties ?? {}).find(([pattern]) => new RegExp(pattern, 'u').test(key));
    part = part?.properties?.[key] ?? open?.[1];
  }
  return Object.keys(part?.properties ?? {});
}

const INSTEAD = /\binstead of\b/;

/**
 * Inputs of which a case states one beside `path` at most: input.power beside input.torque. The schema has
 * them as a choice of one, or says of all but the first that they are stated instead of it.
 */
export function alternativesOf(schema, model, path) {
  let part = schema.$defs[model];
  for (const key of path.slice(0, -1)) part = part?.properties?.[key];
  const parts = [part, ...(part?.allOf ?? [])], properties = part?.properties ?? {};
  const single = (one) => (one.required?.length === 1 && !one.properties ? one.required[0] : null);
  const namesOf = (list) => (list.every(single) ? list.map(single) : []);
  const replaces = (names) =>
      names.slice(1).every((name) => INSTEAD.test(properties[name]?.description ?? ''));
  const choices = [
    ...parts.map((one) => one?.oneOf).filter(Boolean).map(namesOf),
    ...parts.map((one) => one?.anyOf).filter(Boolean).map(namesOf).filter(replaces)
  ].find((names) => names.includes(path.at(-1)));
  return (choices ?? []).filter((key) => key !== path.at(-1)).map((key) => [...path.slice(0, -1), key]);
}

// Units in use beside that of the example; any other may be typed.
const UNITS = {
  length: ['um', 'mm', 'cm', 'm', 'inch'],
  angle: ['mrad', 'rad', 'arc_minute', 'deg'],
  power: ['W', 'kW', 'MW', 'hp'],
  torque: ['N.m', 'kN.m', 'lbf.ft'],
  moment: ['N.m', 'kN.m'],
  'angular speed': ['rpm', 'rad/s', 'deg/s'],
  'angular acceleration': ['rpm/s', 'rad/s2'],
  force: ['N', 'kN', 'MN', 'lbf'],
  mass: ['g', 'kg', 't', 'lb'],
  stiffness: ['N/m', 'N/mm', 'N/um', 'MN/m'],
  pressure: ['Pa', 'MPa', 'GPa', 'psi'],
  stress: ['MPa', 'GPa', 'psi'],
  density: ['kg/m3', 'g/cm3'],
  'dynamic viscosity': ['mPa.s', 'Pa.s'],
  'kinematic viscosity': ['mm2/s', 'm2/s'],
  temperature: ['degC', 'K', 'degF'],
  time: ['us', 'ms', 's', 'min', 'h'],
  frequency: ['Hz', 'kHz'],
  speed: ['mm/s', 'm/s'],
  'moment of inertia': ['kg.m2', 'kg.mm2'],
};

/** Units that a field offers. */
export function unitsOf(field, present) {
  const own = quantityOf(field.example)?.unit;
  return [...new Set([present, own, ...(UNITS[field.dimension] ?? [])].filter(Boolean))];
}
