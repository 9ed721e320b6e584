//! Engines: who there are, in which order, and what they say of themselves.

use std::ffi::{c_long, c_void};

use fillrate_guard::{guard, write};
use fillrate_rave::gestalt::{Answer, optional, selector};
use fillrate_rave::{Call, EngineId};

use crate::engine::{Engine, GetMethod, current_ref_con};
use crate::layout::{PARAM_ERR, RawDevice, device_value, read_device};
use crate::session::{Session, session};

/// `kQAError`.
const ERROR: i32 = 1;
/// `kQAOutOfDate`.
const OUT_OF_DATE: i32 = 4;
/// `kQAGestaltUnknown`.
const GESTALT_UNKNOWN: i32 = 6;
/// Engines that programs may register.
const MAX_ENGINES: usize = 256;

/// An engine as the manager knows it.
#[derive(Clone, Copy)]
pub enum Who {
    /// Ours.
    BuiltIn,
    /// The program's.
    Program(Engine),
}

/// A line of the manager's list.
pub struct Entry {
    /// What programs know it by.
    pub number: u32,
    pub who: Who,
    vendor: u32,
    engine: u32,
    revision: u32,
    is_enabled: bool,
}

/// All engines, in the order of registration. Replaced ones stay for the
/// objects that they made, but are no longer listed.
pub struct Engines {
    entries: Vec<Entry>,
    /// Vendor and number of the one that the user wants first.
    preferred: Option<(u32, u32)>,
}

impl Engines {
    /// The built-in engine alone, with vendor, number and revision.
    pub fn new([vendor, engine, revision]: [u32; 3], preferred: Option<(u32, u32)>) -> Engines {
        let number = EngineId::BUILT_IN.0;
        let who = Who::BuiltIn;
        let built_in = Entry { number, who, vendor, engine, revision, is_enabled: true };
        Engines { entries: vec![built_in], preferred }
    }

    /// An engine by what programs know it by.
    pub fn find(&self, engine: *const c_void) -> Option<Who> {
        let number = u32::try_from(engine as usize).ok()?;
        self.entries.iter().find(|entry| entry.number == number).map(|entry| entry.who)
    }

    /// Adds an engine that says so of itself.
    fn register(&mut self, program: Engine, [vendor, engine, revision]: [u32; 3]) -> i32 {
        let same = |entry: &&mut Entry| (entry.vendor, entry.engine) == (vendor, engine);
        if self.entries.len() >= MAX_ENGINES {
            return ERROR;
        }
        if self.entries.iter_mut().any(|entry| same(&entry) && entry.revision >= revision) {
            return OUT_OF_DATE;
        }
        for entry in self.entries.iter_mut().filter(same) {
            entry.is_enabled = false;
        }
        let number = self.entries.len() as u32 + EngineId::BUILT_IN.0;
        let who = Who::Program(program);
        self.entries.push(Entry { number, who, vendor, engine, revision, is_enabled: true });
        0
    }

    /// Shows or hides the newest engine of an identity.
    fn enable(&mut self, vendor: u32, engine: u32, is_enabled: bool) -> bool {
        let same = |entry: &&mut Entry| (entry.vendor, entry.engine) == (vendor, engine);
        let found = self.entries.iter_mut().filter(same).max_by_key(|entry| entry.revision);
        found.map(|entry| entry.is_enabled = is_enabled).is_some()
    }

    /// Numbers of those that are enabled, who they are, and whether the user wants
    /// them first.
    fn listed(&self) -> Vec<(u32, Who, bool)> {
        let enabled = self.entries.iter().filter(|entry| entry.is_enabled);
        let is_preferred = |entry: &Entry| self.preferred == Some((entry.vendor, entry.engine));
        enabled.map(|entry| (entry.number, entry.who, is_preferred(entry))).collect()
    }
}

impl Session {
    /// The engine behind a pointer of the program.
    pub fn engine(&self, engine: *const c_void) -> Option<Who> {
        self.engines.find(engine)
    }

    fn built_in_number(&mut self, selector: u32) -> u32 {
        match self.context.gestalt(EngineId::BUILT_IN, selector) {
            Ok(Answer::Number(number)) => number,
            _ => 0,
        }
    }
}

/// Whether an engine draws to a device.
///
/// # Safety
/// `device` is null or points to a device.
unsafe fn check_device(who: Who, device: *const RawDevice) -> i32 {
    match who {
        Who::BuiltIn => {
            // SAFETY: the caller's promise.
            let Some(raw) = (unsafe { read_device(device) }) else { return PARAM_ERR };
            let checked = session().context.check_device(EngineId::BUILT_IN, &device_value(&raw));
            fillrate_rave::status_code(&checked)
        }
        // SAFETY: the caller's promise.
        Who::Program(engine) => unsafe { engine.check_device(device.cast()) },
    }
}

/// Engines for a device, best first: the user's choice, those bound to it, then by
/// the number of things they are fast at, then by age.
///
/// # Safety
/// `device` is null or points to a device.
unsafe fn engines_for(device: *const RawDevice) -> Vec<u32> {
    let listed = session().engines.listed();
    let mut found: Vec<([bool; 2], u32, u32)> = Vec::new();
    for (number, who, is_preferred) in listed {
        // SAFETY: the caller's promise.
        if !device.is_null() && unsafe { check_device(who, device) } != 0 {
            continue;
        }
        let ask = |question| match who {
            Who::BuiltIn => session().built_in_number(question),
            Who::Program(engine) => engine.number(question),
        };
        let binds = ask(selector::OPTIONAL_FEATURES) & optional::BOUND_TO_DEVICE != 0;
        let comes_later = device.is_null() || !binds;
        let fast = ask(selector::FAST_FEATURES).count_ones();
        found.push(([!is_preferred, comes_later], 32 - fast, number));
    }
    found.sort_unstable();
    found.into_iter().map(|(_, _, number)| number).collect()
}

fn as_engine(number: Option<u32>) -> *mut c_void {
    number.unwrap_or(0) as usize as *mut c_void
}

/// The best engine for a device, or of all for null; null where there is none.
///
/// # Safety
/// `device` is null or points to a device.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QADeviceGetFirstEngine(device: *const RawDevice) -> *mut c_void {
    guard(std::ptr::null_mut(), || {
        // SAFETY: the caller's promise.
        as_engine(unsafe { engines_for(device) }.first().copied())
    })
}

/// The engine after another; null after the last.
///
/// # Safety
/// `device` is null or points to a device.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QADeviceGetNextEngine(
    device: *const RawDevice,
    current: *const c_void,
) -> *mut c_void {
    guard(std::ptr::null_mut(), || {
        // SAFETY: the caller's promise.
        let engines = unsafe { engines_for(device) };
        let at = engines.iter().position(|&number| number as usize == current as usize);
        as_engine(at.and_then(|at| engines.get(at + 1)).copied())
    })
}

/// `kQANoErr` where an engine draws to a device.
///
/// # Safety
/// `device` is null or points to a device.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAEngineCheckDevice(
    engine: *const c_void,
    device: *const RawDevice,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        if device.is_null() {
            return PARAM_ERR;
        }
        // SAFETY: the caller's promise.
        unsafe { check_device(who, device) }
    })
}

/// Answers a question about an engine.
///
/// # Safety
/// `response` is null or has room for the answer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QAEngineGestalt(
    engine: *const c_void,
    selector: u32,
    response: *mut c_void,
) -> i32 {
    guard(ERROR, || {
        let Some(who) = session().engine(engine) else { return PARAM_ERR };
        if response.is_null() {
            return PARAM_ERR;
        }
        match who {
            // SAFETY: the caller's promise.
            Who::Program(engine) => unsafe { engine.gestalt(selector, response) },
            // SAFETY: the caller's promise.
            Who::BuiltIn => unsafe { built_in_gestalt(selector, response) },
        }
    })
}

/// # Safety
/// `response` has room for the answer.
unsafe fn built_in_gestalt(selector: u32, response: *mut c_void) -> i32 {
    if selector == crate::ati::CURRENT_CONTEXT {
        // SAFETY: the caller's promise.
        return unsafe { crate::ati::current_context(response.cast()) };
    }
    let mut session = session();
    let answer = session.context.gestalt(EngineId::BUILT_IN, selector);
    match answer {
        // SAFETY: the caller's promise.
        Ok(Answer::Number(number)) => unsafe { write(response.cast(), number) },
        Ok(Answer::Text(text)) => {
            let text: Vec<u8> = text.bytes().chain([0]).collect();
            // SAFETY: the caller's promise: room for the name and its end.
            unsafe { response.cast::<u8>().copy_from_nonoverlapping(text.as_ptr(), text.len()) };
        }
        Err(_) => return GESTALT_UNKNOWN,
    }
    0
}

fn enable(vendor: i32, engine: i32, is_enabled: bool) -> i32 {
    guard(ERROR, || {
        let mut session = session();
        let call = match is_enabled {
            true => Call::EngineEnable { vendor, engine },
            false => Call::EngineDisable { vendor, engine },
        };
        session.call(&call);
        let found = session.engines.enable(vendor as u32, engine as u32, is_enabled);
        if found { 0 } else { PARAM_ERR }
    })
}

/// Lists an engine again.
#[unsafe(no_mangle)]
pub extern "C" fn QAEngineEnable(vendor: i32, engine: i32) -> i32 {
    enable(vendor, engine, true)
}

/// No longer lists an engine.
#[unsafe(no_mangle)]
pub extern "C" fn QAEngineDisable(vendor: i32, engine: i32) -> i32 {
    enable(vendor, engine, false)
}

/// Adds an engine of the program.
///
/// # Safety
/// The function is an engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QARegisterEngine(get_method: Option<GetMethod>) -> i32 {
    // SAFETY: the caller's promise.
    unsafe { QARegisterEngineWithRefCon(get_method, 0) }
}

/// Adds an engine, with a number that its methods can ask for.
///
/// # Safety
/// The function is an engine's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn QARegisterEngineWithRefCon(
    get_method: Option<GetMethod>,
    ref_con: c_long,
) -> i32 {
    guard(ERROR, || {
        let Some(get_method) = get_method else { return PARAM_ERR };
        // SAFETY: the caller's promise.
        match unsafe { Engine::ask(get_method, ref_con) } {
            Ok(engine) => {
                let identity = [selector::VENDOR_ID, selector::ENGINE_ID, selector::REVISION];
                let identity = identity.map(|question| engine.number(question));
                session().engines.register(engine, identity)
            }
            Err(status) => status,
        }
    })
}

/// The number of the engine whose method runs.
#[unsafe(no_mangle)]
pub extern "C" fn QAGetCurrentEngineRefCon() -> c_long {
    current_ref_con()
}

/// Nothing is left to do: the library starts with its first call.
#[unsafe(no_mangle)]
pub extern "C" fn QAInit() -> i32 {
    0
}

/// Nothing is left to do.
#[unsafe(no_mangle)]
pub extern "C" fn QAExit() -> i32 {
    0
}
