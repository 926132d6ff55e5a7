// SPDX-License-Identifier: Apache-2.0
// Groups of equal channels of all planets: one curve for the range of all of them, or one for each.

/** @param {{data: ArrayLike<number>}[]} tables @param {(a: number, b: number) => number} pick */
function over(tables, pick) {
  const data = Float64Array.from(tables[0].data);
  for (const table of tables.slice(1)) for (let k = 0; k < data.length; k++) data[k] = pick(data[k], table.data[k]);
  return { data, shape: [data.length], width: 1, count: data.length };
}

/** @param {{data: ArrayLike<number>}[]} tables */
function mean(tables) {
  const sum = over(tables, (a, b) => a + b);
  for (let k = 0; k < sum.data.length; k++) sum.data[k] /= tables.length;
  return sum;
}

/**
 * Channels of a result with one more for each group: the range of its members, shown in place of them.
 * @param {any[]} channels
 * @returns {any[]}
 */
export function withGroups(channels) {
  const groups = new Map();
  for (const channel of channels) {
    const { name } = channel.group ?? {};
    if (name === undefined) continue;
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(channel);
  }
  const made = new Map();
  for (const [name, members] of groups) {
    const [first] = members;
    if (members.length < 2 || members.some(({ times }) => times.count !== first.times.count)) continue;
    members.sort((a, b) => a.group.planet - b.group.planet);
    made.set(name, {
      ...first,
      name,
      label: first.group.label,
      group: undefined,
      members: members.map((member) => member.name),
      least: over(members.map(({ least }) => least), Math.min),
      most: over(members.map(({ least, most }) => most ?? least), Math.max),
      mean: mean(members.map(({ least, mean }) => mean ?? least)),
      first: members.some((member) => member.first),
    });
    for (const member of members)
      Object.assign(member, {
        whole: name,
        first: false,
        label: first.group.label.replace("planets", `planet ${member.group.planet}`),
      });
  }
  // A group precedes its members.
  return channels.flatMap((channel) => {
    const whole = made.get(channel.whole);
    if (!whole) return [channel];
    made.delete(channel.whole);
    const members = whole.members.map((name) => channels.find((each) => each.name === name));
    return [whole, ...members];
  }).filter((channel, k, all) => all.indexOf(channel) === k);
}
