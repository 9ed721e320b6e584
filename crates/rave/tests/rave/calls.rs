//! Calls as values.

use fillrate_call::{from_bytes, to_bytes};
use fillrate_rave::{Call, ImageValue, VTexture};

#[test]
fn calls_survive_their_encoding() {
    let corner = VTexture { x: 1.0, kd_r: 2.0, inv_w: f32::NAN, ..VTexture::default() };
    let image = ImageValue { width: 1, height: 1, pixels: vec![1, 2, 3, 4].into() };
    let calls = [
        Call::DrawTriTexture { context: 1, a: corner, b: corner, c: corner, flags: 1 },
        Call::TextureNew { engine: 1, flags: 2, pixel_type: 4, images: vec![image] },
        Call::RenderStart { context: 1, dirty: None, initial: 0 },
    ];
    for call in calls {
        let bytes = to_bytes(&call);
        let back: Call = from_bytes(&bytes).unwrap();
        assert_eq!(to_bytes(&back), bytes, "{call}");
        assert_eq!(back.to_string(), call.to_string());
    }
}
