// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Steps a model in MuJoCo's WebAssembly, as a page in a browser would.
//   node step_model.mjs MODULE.js MODEL.xml CONTROLS.json
// MODULE.js is that of the npm package @mujoco/mujoco, CONTROLS.json holds a list of controls for
// every step. Prints as JSON the version and, before the first step and after every one, the joint
// coordinates.
import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [moduleFile, modelFile, controlsFile] = process.argv.slice(2);
const {default: loadMujoco} = await import(pathToFileURL(moduleFile).href);
const mujoco = await loadMujoco();
const model = mujoco.MjModel.from_xml_string(readFileSync(modelFile, 'utf8'));
const data = new mujoco.MjData(model);
const controls = JSON.parse(readFileSync(controlsFile, 'utf8'));
const positions = [Array.from(data.qpos)];
for (const control of controls) {
  if (control.length !== model.nu) {
    throw new Error(`${control.length} controls for a model of ${model.nu}`);
  }
  data.ctrl.set(control);
  mujoco.mj_step(model, data);
  positions.push(Array.from(data.qpos));
}
process.stdout.write(JSON.stringify({
  version: mujoco.mj_versionString(),
  positions,
  warnings: Array.from({length: data.warning.size()}, (_, k) => data.warning.get(k).number),
}));
