'use strict';
const fs = require('fs'), vm = require('vm');
const lines = fs.readFileSync(0, 'latin1').split('\n');  // before the source reads them away
globalThis.require = require;
globalThis.module = { exports: {} };
globalThis.exports = globalThis.module.exports;
process.stdout.write = process.stderr.write.bind(process.stderr);
vm.runInThisContext(fs.readFileSync(__dirname + '/@file@', 'utf8'), { filename: '@file@' });
const entry = vm.runInThisContext('@entry@');
const [parameters, answer] = [[@shapes@], @answer.plain@];
// @if methods
const methods = { @calls@ };
// @end
function read(shape, words) {
  if (shape.kind === 'tuple') return Object.fromEntries(shape.parts.map((part, i) => [shape.fields[i], read(part, words)]));
  if (shape.kind === 'list') return Array.from({ length: +words.pop() }, () => read(shape.parts[0], words));
  if (shape.kind === 'dict') return new Map(Array.from({ length: +words.pop() }, () => shape.parts.map(part => read(part, words))));
  if (shape.kind === 'optional') return words[words.length - 1] === 'none' ? (words.pop(), null) : read(shape.parts[0], words);
  const word = words.pop();
  if (shape.kind === 'bool') return word === 'true';
  if (shape.kind === 'word' || shape.kind === 'text') return word[0] === '=' ? Buffer.from(word.slice(1), 'hex').toString('latin1') : word;
  return shape.kind === 'big' ? BigInt(word) : +word;
}
function told(fault) {
  const place = /@file@:(\d+)/.exec(fault && fault.stack);
  return String(fault) + (place ? ` (line ${place[1]})` : '') + (call ? `, in call ${call}` : '');
}
const odd = (type, text) => JSON.stringify({ type, text: String(text).slice(0, 80) });
function put(value, shape) {
  if (value === null || value === undefined || shape && shape.kind === 'nothing') return 'null';
  if (typeof value === 'bigint' || typeof value === 'boolean') return value.toString();
  if (typeof value === 'number') return Number.isFinite(value) ? String(value) : odd('float', String(value).toLowerCase());
  if (typeof value === 'string') return JSON.stringify(value);
  if (shape && shape.kind === 'optional') return put(value, shape.parts[0]);
  if (Array.isArray(value)) return '[' + value.map((item, i) => put(item, shape && (shape.kind === 'list' ? shape.parts[0] : shape.parts[i]))).join(',') + ']';
  if (shape && shape.kind === 'dict' && (value instanceof Map || Object.getPrototypeOf(value) === Object.prototype)) {
    const own = shape.parts[0].kind, key = text => own === 'int' && String(+text) === text ? +text : own === 'bool' && text in { true: 0, false: 0 } ? text === 'true' : text;
    const entries = value instanceof Map ? [...value] : Object.entries(value).map(([name, item]) => [key(name), item]);
    return '{"dict":[' + entries.map(entry => '[' + entry.map((item, i) => put(item, shape.parts[i])).join(',') + ']').join(',') + ']}';
  }
  if (typeof value === 'object' && shape && shape.kind === 'tuple' && shape.fields.every(field => field in value)) return '[' + shape.fields.map((field, i) => put(value[field], shape.parts[i])).join(',') + ']';
  return odd(typeof value, value);
}
const kind = Object.prototype.toString.call(entry).slice(8, -1);  // which an async function and a generator have of their own
let call = 0;  // which one of calls in a row is made
function answered(words) {
  const given = parameters.map(shape => read(shape, words));
// @if not methods
  if (kind !== 'Function') throw new TypeError(`@entry@ is ${/^A/.test(kind) ? 'an' : 'a'} ${kind}: write it as a function that returns the answer`);
  return put(entry(...given), answer);
// @end
// @if methods
  const made = new entry(...given), count = +words.pop(), found = [];
  for (call = 1; call <= count; call++) {
    const [name, takes, answer] = methods[read({ kind: 'word' }, words)];
    const arguments_ = takes.map(shape => read(shape, words));
    if (typeof made[name] !== 'function') throw new TypeError('there is no method ' + name);
    found.push(put(made[name](...arguments_), answer));
  }
  return '[' + found.join(',') + ']';
// @end
}
for (let at = 0; at < lines.length && lines[at] !== '';) {
  const [cases, atOnce] = lines[at++].split(' ').map(Number);
  let out = '';
  for (let left = cases; left > 0; left--) {
    try {
      const words = lines[at++].split(' ').reverse();
      call = 0;
      out += '[0,' + answered(words) + ']\n';
    } catch (fault) {
      out += '[1,' + JSON.stringify(told(fault)) + ']\n';
    }
    if (atOnce || left === 1) for (let bytes = Buffer.from(out); (out = '', bytes.length); ) bytes = bytes.subarray(fs.writeSync(1, bytes));
  }
}
process.exit(0);
