// SPDX-License-Identifier: GPL-3.0-or-later
// One run of QUEST+ by jsquest-plus (npm), for bench_quest_plus: node quest_plus_peer.mjs MODULE TASK.json
// prints one JSON object: processor time of the set-up and of every trial (ms), and the stimuli chosen.
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const talk = console.log;
console.log = () => {};
const { default: Quest } = await import(pathToFileURL(process.argv[2]).href);
const task = JSON.parse(readFileSync(process.argv[3], 'utf8'));
const right = (x, t, slope, lapse) => 0.5 + (0.5 - lapse) * (1 - Math.exp(-Math.pow(10, slope * (x - t))));
const wrong = (x, t, slope, lapse) => 1 - right(x, t, slope, lapse);
const cpu = () => { const used = process.cpuUsage(); return (used.user + used.system) / 1000; };

const start = cpu();
const quest = new Quest({ psych_func: [wrong, right], stim_samples: [task.stimuli], psych_samples: [task.threshold, task.slope, task.lapse] });
const setUp = cpu() - start;
const chosen = [];
const first = cpu();
for (const response of task.responses) {
    const stimulus = quest.getStimParams();
    chosen.push(stimulus);
    quest.update(stimulus, response);
}
talk(JSON.stringify({ setUp, trial: (cpu() - first) / task.responses.length, chosen }));
