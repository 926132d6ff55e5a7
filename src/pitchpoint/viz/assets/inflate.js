// SPDX-License-Identifier: Apache-2.0
// What DEFLATE (RFC 1951) has packed, at once: a page that is printed as soon as it is there cannot wait for streams.
"use strict";

/** @param {Uint8Array} input packed, without head and check sum @param {number} size bytes that come out */
function inflate(input, size) {
  const WIDEST = 15; // bits of a code
  const out = new Uint8Array(size);
  let at = 0, end = 0, held = 0, count = 0;

  function ask(wanted) {
    if (at > input.length + 8) throw new Error("the packed script is damaged");
    for (; count < wanted; count += 8) held |= (input[at++] || 0) << count;
  }
  function bits(wanted) {
    ask(wanted);
    const found = held & ((1 << wanted) - 1);
    held >>>= wanted;
    count -= wanted;
    return found;
  }

  // What every pattern of the next bits begins with: a symbol times 16, and how many of the bits are its code.
  function codes(lengths) {
    const table = new Uint16Array(1 << WIDEST);
    let code = 0;
    for (let length = 1; length <= WIDEST; length++, code <<= 1) {
      lengths.forEach((own, symbol) => {
        if (own !== length) return;
        let turned = 0; // codes come with their highest bit first
        for (let k = 0; k < length; k++) turned |= ((code >> k) & 1) << (length - 1 - k);
        for (let k = turned; k < table.length; k += 1 << length) table[k] = symbol * 16 + length;
        code++;
      });
    }
    return table;
  }
  function next(table) {
    ask(WIDEST);
    const found = table[held & (table.length - 1)];
    if (!found) throw new Error("the packed script is damaged");
    held >>>= found & 15;
    count -= found & 15;
    return found >> 4;
  }

  // Lengths of codes come as codes themselves, those of which in an order of their own.
  function tables() {
    const [literals, distances, own] = [bits(5) + 257, bits(5) + 1, bits(4) + 4];
    const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15].slice(0, own);
    const first = Array(19).fill(0);
    for (const symbol of order) first[symbol] = bits(3);
    const table = codes(first);
    const lengths = [];
    while (lengths.length < literals + distances) {
      const symbol = next(table);
      if (symbol < 16) lengths.push(symbol);
      else {
        const again = symbol === 16 ? lengths[lengths.length - 1] : 0;
        const times = symbol === 16 ? 3 + bits(2) : symbol === 17 ? 3 + bits(3) : 11 + bits(7);
        for (let k = 0; k < times; k++) lengths.push(again);
      }
    }
    return [codes(lengths.slice(0, literals)), codes(lengths.slice(literals))];
  }
  function fixed() {
    const lengths = Array.from({ length: 288 }, (_, k) => (k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8));
    return [codes(lengths), codes(Array(30).fill(5))];
  }

  // Lengths and distances grow in steps of four and of two symbols, each with a bit more behind it.
  function length(k) {
    if (k < 8) return 3 + k;
    if (k === 28) return 258;
    const more = (k >> 2) - 1;
    return 3 + ((4 + (k & 3)) << more) + bits(more);
  }
  function distance(k) {
    if (k < 4) return 1 + k;
    const more = (k >> 1) - 1;
    return 1 + ((2 + (k & 1)) << more) + bits(more);
  }

  function plain() {
    at -= count >> 3; // whole bytes that were read ahead
    held = count = 0;
    const long = input[at] | (input[at + 1] << 8);
    out.set(input.subarray(at + 4, at + 4 + long), end);
    at += 4 + long;
    end += long;
  }

  for (let last = 0; !last; ) {
    last = bits(1);
    const kind = bits(2);
    if (kind === 0) plain();
    else {
      const [symbols, ways] = kind === 1 ? fixed() : tables();
      for (let symbol = next(symbols); symbol !== 256; symbol = next(symbols)) {
        if (symbol < 256) out[end++] = symbol;
        else {
          const long = length(symbol - 257);
          const from = end - distance(next(ways));
          for (let k = 0; k < long; k++) out[end++] = out[from + k];
        }
      }
    }
  }
  if (end !== size) throw new Error("the packed script is damaged");
  return out;
}
