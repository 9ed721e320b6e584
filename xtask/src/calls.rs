//! What the machine code of the kernels calls.
//!
//! Lanes are functions that must be inlined into a function with the level's
//! instructions. Where that fails, a kernel still draws the right pixels, but
//! calls a function for each operation and is many times slower. This reads
//! the calls of the built stages from a disassembly.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::Path;
use std::process::Command;

use anyhow::{Result, ensure};

use crate::budget::{build, run};

/// Stage functions; their bodies are what they call by [`BODY`].
const STAGES: &str = "fillrate_engine::kernel::stages::";
/// In the name of a body with a level's instructions.
const BODY: &str = "::vectorize::inner";
/// Fewer stages than this mean that names have changed and nothing is checked.
const LEAST_STAGES: usize = 60;

/// What a stage may call: the ends of broken promises, copies, and two things
/// without lanes: the quotient for coordinates beyond 2^53, and the bits of
/// stipples and patterns.
const ALLOWED: [&str; 11] = [
    "__divti3",
    "fillrate_engine::kernel::stipple::",
    "core::panicking::",
    "core::slice::index::",
    "core::slice::copy_from_slice_impl::",
    "core::option::unwrap_failed",
    "core::option::expect_failed",
    "core::result::unwrap_failed",
    "memcpy",
    "memmove",
    "memset",
];

/// What is no stage: it is called once for a state or a tile.
const OUTSIDE: [&str; 1] = ["fillrate_engine::kernel::stages::stage_list"];

/// A function: its name and where it calls, or jumps out of itself, to.
#[derive(Debug, Default, PartialEq, Eq)]
struct Function {
    name: String,
    calls: BTreeSet<Target>,
}

/// Where a call leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    /// A function's address.
    Address(u64),
    /// A slot of the table of addresses that the loader fills.
    Slot(u64),
    /// An address in a register or a structure.
    Unknown,
}

/// Disassembles the kernels and checks every stage's calls.
///
/// # Errors
/// A call that is not allowed; too few stages; no disassembler.
pub fn check(root: &Path) -> Result<()> {
    let program = build(root)?;
    let mut disassemble = Command::new("objdump");
    disassemble.args(["-d", "-C", "--no-show-raw-insn"]).arg(&program);
    let functions = functions(&run(&mut disassemble)?);
    let slots = slots(&run(Command::new("objdump").args(["-R", "-C"]).arg(&program))?);
    let (stages, wrong) = wrong_calls(&functions, &slots);
    ensure!(stages >= LEAST_STAGES, "only {stages} stages are found: have names changed?");
    ensure!(wrong.is_empty(), "calls in kernels:\n{}", wrong.join("\n"));
    println!("{stages} stages call nothing that they should not");
    Ok(())
}

/// The functions of a disassembly by address.
fn functions(text: &str) -> BTreeMap<u64, Function> {
    let mut functions = BTreeMap::new();
    let mut current = 0;
    for line in text.lines() {
        if let Some((address, name)) = header(line) {
            current = address;
            functions.insert(address, Function { name: name.into(), ..Function::default() });
        } else if let (Some(target), Some(function)) = (transfer(line), functions.get_mut(&current))
        {
            function.calls.insert(target);
        }
    }
    // Jumps within a function are no calls.
    let starts: BTreeSet<u64> = functions.keys().copied().collect();
    for function in functions.values_mut() {
        function.calls.retain(|call| !matches!(call, Target::Address(a) if !starts.contains(a)));
    }
    functions
}

/// `address <name>:`
fn header(line: &str) -> Option<(u64, &str)> {
    let (address, rest) = line.split_once(" <")?;
    Some((u64::from_str_radix(address, 16).ok()?, rest.strip_suffix(">:")?))
}

/// The target of a line with a call or a jump to another function.
fn transfer(line: &str) -> Option<Target> {
    let instruction = line.split_once(":\t")?.1;
    let (name, operand) = instruction.split_once(' ')?;
    let operand = operand.trim();
    let call = name.starts_with("call");
    if !call && !name.starts_with('j') {
        return None;
    }
    if let Some(operand) = operand.strip_prefix('*') {
        // Register jumps are tables of a `match`; jumps by a slot are calls.
        let slot = operand.split_once("# ").filter(|(address, _)| address.contains("(%rip)"));
        let slot = slot.and_then(|(_, slot)| slot.split(' ').next());
        return match slot.and_then(|slot| u64::from_str_radix(slot, 16).ok()) {
            Some(slot) => Some(Target::Slot(slot)),
            None => call.then_some(Target::Unknown),
        };
    }
    let address = operand.split(' ').next()?;
    u64::from_str_radix(address, 16).ok().map(Target::Address)
}

/// What the loader puts into slots: an address, or a symbol's name.
fn slots(text: &str) -> HashMap<u64, Result<u64, String>> {
    let mut slots = HashMap::new();
    for line in text.lines() {
        let mut fields = line.split_whitespace();
        let (Some(slot), Some(kind), Some(value)) = (fields.next(), fields.next(), fields.next())
        else {
            continue;
        };
        let Ok(slot) = u64::from_str_radix(slot, 16) else { continue };
        let address = value.strip_prefix("*ABS*+0x").filter(|_| kind.ends_with("RELATIVE"));
        let address = address.and_then(|address| u64::from_str_radix(address, 16).ok());
        slots.insert(slot, address.ok_or_else(|| value.to_string()));
    }
    slots
}

/// How many stages there are, with those of every level, and their calls that
/// are not allowed.
fn wrong_calls(
    functions: &BTreeMap<u64, Function>,
    slots: &HashMap<u64, Result<u64, String>>,
) -> (usize, Vec<String>) {
    let name = |target: Target| -> (Option<u64>, String) {
        let named = |address: u64| functions.get(&address).map(|f| f.name.clone());
        match target {
            Target::Address(address) => (Some(address), named(address).unwrap_or_default()),
            Target::Slot(slot) => match slots.get(&slot) {
                Some(Ok(address)) => (Some(*address), named(*address).unwrap_or_default()),
                Some(Err(symbol)) => (None, symbol.clone()),
                None => (None, format!("slot {slot:x}")),
            },
            Target::Unknown => (None, "a function held in a register".into()),
        }
    };
    let is_stage = |f: &Function| f.name.starts_with(STAGES) && !OUTSIDE.contains(&f.name.as_str());
    let mut bodies: BTreeMap<u64, String> = BTreeMap::new();
    for (address, stage) in functions.iter().filter(|(_, f)| is_stage(f)) {
        bodies.insert(*address, stage.name.clone());
        for (target, callee) in stage.calls.iter().map(|call| name(*call)) {
            if let Some(target) = target.filter(|_| callee.ends_with(BODY)) {
                bodies.insert(target, format!("{} {callee}", stage.name));
            }
        }
    }
    let mut wrong = Vec::new();
    for (address, body) in &bodies {
        for call in &functions[address].calls {
            let (target, callee) = name(*call);
            let inside = target.is_some_and(|target| bodies.contains_key(&target));
            if !inside && !ALLOWED.iter().any(|allowed| callee.starts_with(allowed)) {
                wrong.push(format!("{body} calls {callee}"));
            }
        }
    }
    (bodies.len(), wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
0000000000001000 <fillrate_engine::kernel::stages::fog>:
    1000:\tjmp    2000 <<fillrate_simd::x86::avx2::Avx2 as S>::vectorize::inner>

0000000000002000 <<fillrate_simd::x86::avx2::Avx2 as S>::vectorize::inner>:
    2000:\tje     2040 <<fillrate_simd::x86::avx2::Avx2 as S>::vectorize::inner+0x40>
    2004:\tcall   *0x100(%rip)        # 9000 <_DYNAMIC+0x10>
    200a:\tcall   *0x108(%rip)        # 9008 <_DYNAMIC+0x18>
    2010:\tjmp    *%rax

0000000000003000 <core::panicking::panic_bounds_check>:
    3000:\tud2

0000000000004000 <core::core_arch::x86::avx2::_mm256_add_epi32>:
    4000:\tret
";
    const SLOTS: &str = "
0000000000009000 R_X86_64_RELATIVE  *ABS*+0x0000000000003000
0000000000009008 R_X86_64_GLOB_DAT  memcpy@GLIBC_2.14
";

    #[test]
    fn panics_and_copies_are_allowed() {
        assert_eq!(wrong_calls(&functions(TEXT), &slots(SLOTS)), (2, vec![]));
    }

    #[test]
    fn lanes_that_are_not_inlined_are_found() {
        let text = TEXT.replace("jmp    *%rax", "call   4000 <core::core_arch::x86::add>");
        let (_, wrong) = wrong_calls(&functions(&text), &slots(SLOTS));
        assert_eq!(wrong.len(), 1);
        assert!(wrong[0].ends_with("calls core::core_arch::x86::avx2::_mm256_add_epi32"));
        let text = TEXT.replace("jmp    *%rax", "call   *%rax");
        assert_eq!(wrong_calls(&functions(&text), &slots(SLOTS)).1.len(), 1);
        let floor = SLOTS.replace("memcpy", "floorf");
        assert_eq!(wrong_calls(&functions(TEXT), &slots(&floor)).1.len(), 1);
    }
}
