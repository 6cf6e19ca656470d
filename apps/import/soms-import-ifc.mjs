// soms-import-ifc.mjs FOLDER .ifc: reads an IFC model from standard input by the npm package web-ifc
// that lies in FOLDER, and writes it to standard output as soms-import does (docs/formats.md). Exit status 1: it cannot be read,
// and standard output says why; 4: too little memory.
import { readFileSync, writeSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const BUFFER = 1 << 20;

/** The records of an answer, written in large pieces. */
class Answer {
  constructor() {
    this.bytes = Buffer.alloc(BUFFER);
    this.used = 0;
    this.vertices = 0;
    this.put(Buffer.from('soms-import 1\n'));
  }

  flush() {
    for (let at = 0; at < this.used;) {
      try {
        at += writeSync(1, this.bytes, at, this.used - at);
      } catch (error) {
        if (error.code !== 'EAGAIN') {
          throw error;
        }
      }
    }
    this.used = 0;
  }

  room(size) {
    if (this.used + size > this.bytes.length) {
      this.flush();
    }
    if (size > this.bytes.length) {
      this.bytes = Buffer.alloc(size);
    }
  }

  put(bytes) {
    this.room(bytes.length);
    bytes.copy(this.bytes, this.used);
    this.used += bytes.length;
  }

  letter(kind) {
    this.room(1);
    this.used = this.bytes.writeUInt8(kind.charCodeAt(0), this.used);
  }

  number(value) {
    this.room(4);
    this.used = this.bytes.writeUInt32LE(value, this.used);
  }

  double(value) {
    this.room(8);
    this.used = this.bytes.writeDoubleLE(value, this.used);
  }

  words(text) {
    const bytes = Buffer.from(text, 'utf8');
    this.number(bytes.length);
    this.put(bytes);
  }

  text(kind, text) {
    this.letter(kind);
    this.words(text);
  }

  describe(id, type, attributes) {
    this.letter('d');
    this.words(id);
    this.words(type);
    this.number(attributes.length);
    attributes.flat().forEach((text) => this.words(text));
  }

  georeference({ crs, datum, map }) {
    this.text('g', crs);
    this.words(datum);
    this.number(map ? 1 : 0);
    (map ?? []).forEach((value) => this.double(value));
  }

  end() {
    this.letter('.');
    this.flush();
  }
}

/** A value of a line as text; nothing for what is unset. */
function plain(value) {
  const held = value?.value ?? value;
  return held === null || held === undefined || typeof held === 'object' ? '' : String(held);
}

/** For each element, what it is directly part of or contained in. */
function holders(api, model, package_) {
  const held = new Map();
  const read = (type, holder, elements) => {
    const lines = api.GetLineIDsWithType(model, type);
    for (let k = 0; k < lines.size(); ++k) {
      const line = api.GetLine(model, lines.get(k));
      for (const element of line[elements] ?? []) {
        if (element?.value !== undefined && line[holder]?.value !== undefined) {
          held.set(element.value, line[holder].value);
        }
      }
    }
  };
  read(package_.IFCRELAGGREGATES, 'RelatingObject', 'RelatedObjects');
  read(package_.IFCRELCONTAINEDINSPATIALSTRUCTURE, 'RelatingStructure', 'RelatedElements');
  return held;
}

/** The storey that an element is on, or what else of the spatial structure holds it; 0 if nothing does. */
function storeyOf(api, model, held, element) {
  const seen = new Set();
  let last = 0;
  for (let at = held.get(element); at !== undefined && !seen.has(at); at = held.get(at)) {
    seen.add(at);
    const type = api.GetNameFromTypeCode(api.GetLineType(model, at));
    if (type === 'IfcBuildingStorey') {
      return at;
    }
    if (last === 0 && (type === 'IfcSpace' || type === 'IfcBuilding' || type === 'IfcSite')) {
      last = at;
    }
  }
  return last;
}

/** The lines of these types and of all that inherit from them by the schema of the model. */
function linesOf(api, model, types) {
  const all = new Set();
  for (const type of types) {
    const lines = api.GetLineIDsWithType(model, type, true);
    for (let k = 0; k < lines.size(); ++k) {
      all.add(lines.get(k));
    }
  }
  return all;
}

/** The lines whose shape is no body: holes, virtual elements, and spaces of any kind. A site is a body: its shape is the ground. */
function bodiless(api, model, package_) {
  // IFC 2x3 knows no IfcSpatialElement.
  const all = linesOf(api, model, [package_.IFCFEATUREELEMENTSUBTRACTION, package_.IFCVIRTUALELEMENT,
    package_.IFCSPATIALELEMENT, package_.IFCSPATIALSTRUCTUREELEMENT]);
  linesOf(api, model, [package_.IFCSITE]).forEach((site) => all.delete(site));
  return all;
}

/** A note of the elements that state a shape and gave no triangles; '' if there are none. */
function lost(api, model, package_, empty, found) {
  let count = 0;
  let first = '';
  for (const id of linesOf(api, model, [package_.IFCELEMENT, package_.IFCSITE])) {
    const line = found.has(id) || empty.has(id) ? null : api.GetLine(model, id);
    if (line?.Representation) {
      first ||= `${api.GetNameFromTypeCode(api.GetLineType(model, id))} '${plain(line.Name)}' (${plain(line.GlobalId)})`;
      ++count;
    }
  }
  return count === 0 ? '' : `elements with a shape of which web-ifc makes no triangles, not read: ${count}, the first ${first}`;
}

/** Meters a unit of length; 0 where it is not stated. */
function metersOf(api, model, reference) {
  const unit = reference?.value === undefined ? null : api.GetLine(model, reference.value);
  if (unit?.ConversionFactor) {
    const factor = api.GetLine(model, unit.ConversionFactor.value);
    return Number(plain(factor.ValueComponent)) * metersOf(api, model, factor.UnitComponent) || 0;
  }
  const prefixes = { EXA: 1e18, PETA: 1e15, TERA: 1e12, GIGA: 1e9, MEGA: 1e6, KILO: 1e3, HECTO: 1e2, DECA: 10, '': 1,
    DECI: 0.1, CENTI: 0.01, MILLI: 1e-3, MICRO: 1e-6, NANO: 1e-9, PICO: 1e-12, FEMTO: 1e-15, ATTO: 1e-18 };
  return plain(unit?.Name) === 'METRE' ? prefixes[plain(unit.Prefix)] ?? 0 : 0;
}

/** A number that a line states, or else another. */
const stated = (value, otherwise) => (plain(value) !== '' && Number.isFinite(Number(plain(value))) ? Number(plain(value)) : otherwise);

/** What a conversion states, in the order of the answer. */
function conversionOf(line, unit) {
  return [stated(line.Eastings ?? line.FirstCoordinate, 0), stated(line.Northings ?? line.SecondCoordinate, 0),
    stated(line.OrthogonalHeight ?? line.Height, 0), stated(line.XAxisAbscissa, 1), stated(line.XAxisOrdinate, 0),
    stated(line.Scale, 1), stated(line.FactorX, 1), stated(line.FactorY, 1), stated(line.FactorZ, 1), unit];
}

/** The properties of the sets of a name; IFC 2x3 has no other place for a map conversion. */
function propertiesOf(api, model, package_, name) {
  const found = {};
  for (const id of linesOf(api, model, [package_.IFCPROPERTYSET])) {
    const set = api.GetLine(model, id);
    if (plain(set.Name).toLowerCase() === name) {
      for (const { value } of set.HasProperties ?? []) {
        const property = api.GetLine(model, value);
        found[plain(property.Name)] = property.NominalValue;
      }
    }
  }
  return found;
}

/** Where the model says that it lies on the Earth, each different one once. */
function georeferences(api, model, package_, bytes) {
  const all = [];
  for (const id of linesOf(api, model, [package_.IFCCOORDINATEOPERATION])) {
    const line = api.GetLine(model, id);
    const crs = line.TargetCRS?.value === undefined ? {} : api.GetLine(model, line.TargetCRS.value);
    all.push({ crs: plain(crs.Name), datum: plain(crs.VerticalDatum), map: conversionOf(line, metersOf(api, model, crs.MapUnit)) });
  }
  if (all.length === 0 && (bytes.includes('ePset_MapConversion') || bytes.includes('ePSet_MapConversion'))) {
    const line = propertiesOf(api, model, package_, 'epset_mapconversion');
    const crs = propertiesOf(api, model, package_, 'epset_projectedcrs');
    const unit = { METRE: 1, METER: 1, M: 1 }[plain(crs.MapUnit).toUpperCase()] ?? 0;
    all.push({ crs: plain(crs.Name) || plain(line.TargetCRS), datum: plain(crs.VerticalDatum), map: conversionOf(line, unit) });
  }
  return [...new Map(all.map((one) => [JSON.stringify(one), one])).values()];
}

function openPart(api, model, answer, element) {
  const line = api.GetLine(model, element);
  answer.text('b', plain(line.Name));
  const attributes = ['ObjectType', 'Tag', 'Description', 'LongName', 'PredefinedType']
    .map((name) => [name, plain(line[name])]).filter(([, value]) => value !== '');
  answer.describe(plain(line.GlobalId), api.GetNameFromTypeCode(api.GetLineType(model, element)), attributes);
}

/** The vertices and triangles of one placed geometry. web-ifc turns y up; here z is up again, as in the file. */
function readGeometry(api, model, { geometryExpressID, flatTransformation: m }) {
  const geometry = api.GetGeometry(model, geometryExpressID);
  const points = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
  const corners = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize()).slice();
  geometry.delete();
  const vertices = new Float64Array(3 * Math.floor(points.length / 6)); // of six numbers, three are a normal
  for (let k = 0; 3 * k < vertices.length; ++k) {
    const [x, y, z] = [points[6 * k], points[6 * k + 1], points[6 * k + 2]];
    vertices[3 * k] = m[0] * x + m[4] * y + m[8] * z + m[12];
    vertices[3 * k + 1] = -(m[2] * x + m[6] * y + m[10] * z + m[14]);
    vertices[3 * k + 2] = m[1] * x + m[5] * y + m[9] * z + m[13];
  }
  return { vertices, corners };
}

function writeGeometry(answer, { vertices, corners }) {
  const first = answer.vertices;
  for (let k = 0; k < vertices.length; k += 3) {
    answer.letter('v');
    answer.double(vertices[k]);
    answer.double(vertices[k + 1]);
    answer.double(vertices[k + 2]);
  }
  for (let k = 0; k + 2 < corners.length; k += 3) {
    answer.letter('f');
    answer.number(3);
    answer.number(first + corners[k]);
    answer.number(first + corners[k + 1]);
    answer.number(first + corners[k + 2]);
  }
  answer.vertices += vertices.length / 3;
}

async function main() {
  const folder = process.argv[2];
  const bytes = readFileSync(0);
  if (!bytes.subarray(0, 1024).includes('ISO-10303-21')) {
    throw new Error('it does not begin as an IFC file does (ISO-10303-21)');
  }
  if (!bytes.subarray(-1024).includes('END-ISO-10303-21')) {
    throw new Error('it is cut off: END-ISO-10303-21 is missing');
  }
  const load = createRequire(join(folder, 'package.json'));
  const package_ = load('./web-ifc-api-node.js');
  const { version } = load('./package.json');
  console.log = () => {}; // standard output is for the answer
  const api = new package_.IfcAPI();
  await api.Init();
  api.SetLogLevel(package_.LogLevel.LOG_LEVEL_OFF);
  const model = api.OpenModel(bytes, { COORDINATE_TO_ORIGIN: false });
  const schema = model < 0 ? '' : api.GetModelSchema(model);
  if (!schema) {
    throw new Error('it is no IFC file, or of a schema that web-ifc does not know');
  }
  const held = holders(api, model, package_);
  const storeys = new Map();
  const empty = bodiless(api, model, package_);
  const found = new Set();
  api.StreamAllMeshes(model, (mesh) => {
    if (empty.has(mesh.expressID)) {
      return;
    }
    const geometries = []; // what web-ifc hands out here is gone after this call
    for (let k = 0; k < mesh.geometries.size(); ++k) {
      geometries.push(readGeometry(api, model, mesh.geometries.get(k)));
    }
    if (!geometries.some(({ corners }) => corners.length >= 3)) {
      return;
    }
    found.add(mesh.expressID);
    const storey = storeyOf(api, model, held, mesh.expressID);
    if (!storeys.has(storey)) {
      storeys.set(storey, []);
    }
    storeys.get(storey).push([mesh.expressID, geometries]);
  });
  const answer = new Answer();
  answer.text('n', `read by web-ifc ${version} (${schema}): coordinates are floats in the frame of each element, lengths became meters, its rotation from z up to y up was undone`);
  const left = lost(api, model, package_, empty, found);
  if (left !== '') {
    answer.text('n', left);
  }
  const [place, ...others] = georeferences(api, model, package_, bytes);
  if (place) {
    answer.georeference(place);
  }
  if (others.length > 0) {
    answer.text('n', `further map conversions, which differ from the first, not read: ${others.length}`);
  }
  answer.letter('u');
  answer.double(1);
  answer.letter('a');
  answer.letter('z');
  for (const [storey, elements] of [...storeys].sort(([a], [b]) => a - b)) {
    if (storey !== 0) {
      openPart(api, model, answer, storey);
    }
    for (const [element, geometries] of elements) {
      openPart(api, model, answer, element);
      geometries.forEach((geometry) => writeGeometry(answer, geometry));
      answer.letter('e');
    }
    if (storey !== 0) {
      answer.letter('e');
    }
  }
  answer.end();
}

function refuse(error) {
  const why = String(error?.message ?? error);
  const memory = /out of memory|allocation failed|Array buffer|enlarge memory|Aborted\(OOM/i.test(why);
  writeSync(1, memory ? '' : why || 'web-ifc cannot read it');
  process.exit(memory ? 4 : 1);
}

main().catch(refuse);
