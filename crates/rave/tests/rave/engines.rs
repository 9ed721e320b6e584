//! The manager: enumeration, gestalt, and engines of the application.

use std::sync::{Arc, Mutex};

use fillrate_call::Tagged;
use fillrate_rave::constants::vertex_mode;
use fillrate_rave::gestalt::{Answer, fast, optional, selector};
use fillrate_rave::{
    APPLE_SOFTWARE, Call, Context, DeviceValue, Engine, EngineId, FILLRATE, PixelType, RaveConfig,
    RaveError, Reply, VGouraud,
};

use crate::scene::{colored, config, context_new, memory};

/// An engine that writes down what it is asked.
#[derive(Debug)]
struct Foreign {
    identity: (i32, i32),
    revision: u32,
    fast: u32,
    offers: Vec<u16>,
    heard: Arc<Mutex<Vec<Call>>>,
}

impl Engine for Foreign {
    fn gestalt(&mut self, which: u32) -> Result<Answer, RaveError> {
        Ok(Answer::Number(match which {
            selector::VENDOR_ID => self.identity.0 as u32,
            selector::ENGINE_ID => self.identity.1 as u32,
            selector::REVISION => self.revision,
            selector::FAST_FEATURES => self.fast,
            selector::OPTIONAL_FEATURES => optional::TEXTURE,
            _ => return Err(RaveError::GestaltUnknown),
        }))
    }

    fn check_device(&mut self, device: Option<&DeviceValue>) -> Result<(), RaveError> {
        match device {
            Some(device) if device.pixel_type == PixelType::Rgb16.number() => {
                Err(RaveError::DisplayModeUnsupported)
            }
            _ => Ok(()),
        }
    }

    fn offers(&self, call: u16) -> bool {
        self.offers.contains(&call)
    }

    fn execute(&mut self, call: &Call, number: u32) -> Reply {
        self.heard.lock().unwrap().push(call.clone());
        match call {
            Call::DrawContextNew { .. } => Reply::Created(Ok(number)),
            Call::RenderEnd { .. } => Reply::Status(Ok(())),
            _ => Reply::Nothing,
        }
    }
}

fn foreign(
    identity: (i32, i32),
    revision: u32,
    fast: u32,
) -> (Box<Foreign>, Arc<Mutex<Vec<Call>>>) {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let context = 1;
    let v = VGouraud::default();
    let offers = [
        Call::DrawContextDelete { context }.tag(),
        Call::DrawPoint { context, v }.tag(),
        Call::DrawLine { context, a: v, b: v }.tag(),
        Call::DrawTriGouraud { context, a: v, b: v, c: v, flags: 0 }.tag(),
        Call::RenderEnd { context, modified: None }.tag(),
    ];
    let engine =
        Foreign { identity, revision, fast, offers: offers.to_vec(), heard: heard.clone() };
    (Box::new(engine), heard)
}

#[test]
fn the_engine_says_what_it_is() {
    let mut library = Context::new(config());
    let ours = EngineId::BUILT_IN;
    assert_eq!(library.engines(None), [ours]);
    let number = |library: &mut Context, which| match library.gestalt(ours, which) {
        Ok(Answer::Number(number)) => number,
        other => panic!("{other:?}"),
    };
    assert_eq!(number(&mut library, selector::VENDOR_ID) as i32, FILLRATE.0);
    let Ok(Answer::Text(name)) = library.gestalt(ours, selector::ASCII_NAME) else { panic!() };
    assert_eq!(number(&mut library, selector::ASCII_NAME_LENGTH) as usize, name.len());
    let optional = number(&mut library, selector::OPTIONAL_FEATURES);
    assert_eq!(optional & optional::CSG, 0);
    assert_ne!(number(&mut library, selector::FAST_FEATURES) & fast::FOG_DEPTH, 0);
    for unknown in [18, 999, 1000, u32::MAX] {
        assert_eq!(library.gestalt(ours, unknown), Err(RaveError::GestaltUnknown));
    }
    assert_eq!(library.gestalt(EngineId(9), 0), Err(RaveError::Parameter));
    // Every type that is said to be allowed makes a context.
    let allowed = number(&mut library, selector::DRAW_CONTEXT_PIXEL_TYPES_ALLOWED);
    for pixel_type in PixelType::ALL {
        let made = library.execute(&context_new(8, 8, pixel_type, 0)).created() != 0;
        assert_eq!(made, allowed & pixel_type.bit() != 0, "{pixel_type:?}");
    }
}

#[test]
fn programs_find_apples_engine_where_asked_for() {
    let mut library = Context::new(RaveConfig { as_apple_software: true, ..config() });
    let vendor = library.gestalt(EngineId::BUILT_IN, selector::VENDOR_ID);
    assert_eq!(vendor, Ok(Answer::Number(APPLE_SOFTWARE.0 as u32)));
}

#[test]
fn engines_are_ordered_and_replaced() {
    let mut library = Context::new(config());
    let (fast_one, _) = foreign((77, 1), 1, u32::MAX);
    let fast_one = library.register_engine(fast_one).unwrap();
    let (slow_one, _) = foreign((77, 2), 1, 0);
    let slow_one = library.register_engine(slow_one).unwrap();
    let ours = EngineId::BUILT_IN;
    assert_eq!(library.engines(None), [fast_one, ours, slow_one]);
    let device = memory(8, 8, PixelType::Rgb16);
    assert_eq!(library.engines(Some(&device)), [ours]);
    assert_eq!(library.check_device(fast_one, &device), Err(RaveError::DisplayModeUnsupported));
    library.prefer_engine(77, 2);
    assert_eq!(library.engines(None), [slow_one, fast_one, ours]);
    library.execute(&Call::EngineDisable { vendor: 77, engine: 2 });
    assert_eq!(library.engines(None), [fast_one, ours]);
    library.execute(&Call::EngineEnable { vendor: 77, engine: 2 });
    let (old, _) = foreign((77, 1), 1, 0);
    assert_eq!(library.register_engine(old).unwrap_err(), RaveError::OutOfDate);
    let (newer, _) = foreign((77, 1), 2, u32::MAX);
    let newer = library.register_engine(newer).unwrap();
    assert_eq!(library.engines(None), [slow_one, newer, ours]);
}

/// The manager splits what an engine has no method for.
#[test]
fn arrays_are_split_for_engines_without_them() {
    let mut library = Context::new(config());
    let (engine, heard) = foreign((77, 1), 1, 0);
    let engine = library.register_engine(engine).unwrap().0;
    let Call::DrawContextNew { device, rect, .. } = context_new(8, 8, PixelType::Rgb32, 0) else {
        panic!()
    };
    let call = Call::DrawContextNew { engine, device, rect, scaled: None, clip: None, flags: 0 };
    let context = library.execute(&call).created();
    let v: Vec<VGouraud> = (0..5).map(|i| colored([1.0; 3], i as f32)).collect();
    let flags = Some(vec![1, 0, 1]);
    let (mode, vertices) = (vertex_mode::FAN, v.clone());
    library.execute(&Call::DrawVGouraud { context, mode, vertices, flags });
    let (mode, vertices) = (vertex_mode::POLYLINE, v.clone());
    library.execute(&Call::DrawVGouraud { context, mode, vertices, flags: None });
    let reply = library.execute(&Call::SwapBuffers { context, dirty: None });
    assert_eq!(reply, Reply::Status(Err(RaveError::NotSupported)));
    let heard = heard.lock().unwrap();
    let tri =
        |i: usize, flags| Call::DrawTriGouraud { context, a: v[0], b: v[i], c: v[i + 1], flags };
    assert_eq!(heard[1..4], [tri(1, 1), tri(2, 0), tri(3, 1)]);
    assert_eq!(heard[4], Call::DrawLine { context, a: v[0], b: v[1] });
    assert_eq!(heard.len(), 8);
}
