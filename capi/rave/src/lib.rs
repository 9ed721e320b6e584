//! `librave`: QuickDraw 3D RAVE as C programs and engines know it, for
//! `RAVE.h` and `RAVE_system.h`.
//!
//! The manager lists engines: the built-in one, and those that programs
//! register. A draw context is a structure of methods which programs call
//! through. Those of the built-in engine check pointers, make calls of
//! `fillrate-rave`, and carry pixels to the program's memory; those of a
//! program's engine are its own, and the manager only splits arrays and meshes
//! where it has no method for them.
//!
//! Objects are handed out as numbers in the place of pointers, which nothing
//! follows: whatever a program passes back is looked up.

mod access;
mod ati;
mod context;
mod draw;
mod engine;
mod export;
mod fallback;
mod layout;
mod manager;
mod notice;
mod object;
mod order;
mod render;
mod session;
mod settings;
