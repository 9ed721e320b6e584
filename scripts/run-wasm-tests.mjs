// Runs a test binary of the wasm32-unknown-unknown target: node run-wasm-tests.mjs FILE.
//
// That target has neither output nor unwinding, so the test harness prints
// nothing, skips tests that expect a panic, and traps at the first failure;
// the trap's stack names the test in mangled form ("5tests" is our module).
import { readFileSync } from "node:fs";

const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), {});
try {
  const code = instance.exports.main(0, 0);
  console.log(code === 0 ? "all tests passed" : `the tests ended with ${code}`);
  process.exitCode = code;
} catch (trap) {
  const frames = (trap.stack ?? String(trap)).split("\n");
  console.log("a test failed:");
  console.log(frames.filter((line, at) => at === 0 || /5tests\d/.test(line)).join("\n"));
  process.exitCode = 1;
}
