//! The client: calls in, protocol records out.
//!
//! Source: RAW, client listing (`render_client.h`).

use crate::call::Call;
use crate::color::pack;
use crate::errata::Errata;
use crate::matrix::{self, IDENTITY, Matrix};
use crate::opcode::Opcode;
use crate::protocol::{Record, padded};

/// Turns calls into records, keeping what the client library kept: whether a scene is open, and
/// the projection and camera matrices.
#[derive(Clone, Debug)]
pub struct Client {
    in_scene: bool,
    projection: Matrix,
    camera: Matrix,
    errata: Errata,
    records: Vec<Record>,
    /// The last record announced text for the log.
    text_follows: bool,
}

impl Client {
    /// A fresh client.
    pub fn new(errata: Errata) -> Self {
        Self {
            in_scene: false,
            projection: IDENTITY,
            camera: IDENTITY,
            errata,
            records: Vec::new(),
            text_follows: false,
        }
    }

    /// Whether a scene is open.
    pub fn in_scene(&self) -> bool {
        self.in_scene
    }

    /// Takes the records made so far.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// Adds a meta record.
    pub fn meta(&mut self, record: Record) {
        self.records.push(record);
    }

    /// Executes one call.
    pub fn call(&mut self, call: &Call) {
        let words = call.words(self.in_scene);
        match call {
            Call::Init {} => {
                *self = Self { records: self.take_records(), ..Self::new(self.errata) }
            }
            Call::BeginScene {} if !self.in_scene => self.begin_scene(),
            Call::EndScene {} if self.in_scene => self.end_scene(),
            Call::BeginPrim {} if self.in_scene => self.meta(Record::Prim),
            Call::EndPrim {} if self.in_scene => self.send(&[0]),
            Call::AsyncReset {} => {
                self.meta(Record::AsyncReset);
                self.call(&Call::Init {});
            }
            Call::SendWord { word } => self.send(&[*word]),
            Call::Meta { text } => self.text(text),
            _ if words.is_empty() => {}
            _ if self.in_scene => {
                self.send(&[words.len() as u32]);
                self.send(&words);
            }
            _ => self.command(call, &words),
        }
    }

    /// A record by its name; what follows a debug record, and what is no record, goes as text.
    fn text(&mut self, text: &str) {
        let text_follows = std::mem::take(&mut self.text_follows);
        let record = match Record::from_text(text) {
            Ok(record) if !text_follows => record,
            _ => Record::Text(padded(text)),
        };
        self.text_follows = record == Record::Debug;
        self.meta(record);
    }

    fn send(&mut self, words: &[u32]) {
        self.records.extend(words.iter().map(|w| Record::Data(*w)));
    }

    fn command(&mut self, call: &Call, words: &[u32]) {
        self.send(words);
        match call {
            // The listing's loop runs one word past the end of the caller's array.
            Call::UploadTexture { .. } if self.errata.upload_one_extra => self.send(&[0]),
            Call::Reset {} => self.call(&Call::Init {}),
            _ => {}
        }
        let answers = call.answers(false);
        if answers > 0 {
            self.meta(Record::Read);
            self.send(&[answers]);
        }
    }

    fn begin_scene(&mut self) {
        self.send(&[Opcode::BeginScene as u32]);
        self.meta(Record::Wait);
        self.meta(Record::EnterScene);
        self.in_scene = true;
    }

    fn end_scene(&mut self) {
        self.send(&[1, Opcode::EndScene as u32, 0]);
        self.meta(Record::Wait);
        self.meta(Record::ExitScene);
        self.in_scene = false;
    }

    /// Sets one of the mode fields or the texture id.
    pub fn set(&mut self, op: Opcode, value: u32) {
        self.call(&Call::Set { opcode: op as u32, value });
    }

    /// Sets the colour from four channels, each cut to eight bits.
    pub fn color(&mut self, r: u32, g: u32, b: u32, a: u32) {
        self.call(&Call::Color { rgba: pack(r, g, b, a) });
    }

    /// Sends a vertex.
    pub fn vertex(&mut self, p: [f32; 3], uv: [f32; 2]) {
        self.call(&Call::Vertex { x: p[0], y: p[1], z: p[2], u: uv[0], v: uv[1] });
    }

    /// Packs the colour of a light; the listing masks its channels with 0x0f.
    pub fn light_color(&self, r: u32, g: u32, b: u32, intensity: u32) -> u32 {
        let mask = if self.errata.light_colors_masked { 0x0f } else { 0xff };
        pack(r & mask, g & mask, b & mask, intensity & mask)
    }

    /// Sets the projection and sends the new view matrix.
    pub fn set_projection(&mut self, projection: Matrix) {
        self.projection = projection;
        self.update_matrices();
    }

    /// Sets the camera and sends the new view matrix.
    pub fn set_camera(&mut self, eye: [f32; 3], focus: [f32; 3], up: [f32; 3]) {
        self.camera = self.camera_matrix(eye, focus, up);
        self.update_matrices();
    }

    /// A camera at `eye` that looks at `focus`, with `up` a point upwards.
    pub fn camera_matrix(&self, eye: [f32; 3], focus: [f32; 3], up: [f32; 3]) -> Matrix {
        matrix::camera(eye, focus, up, self.errata.camera_axes_scaled)
    }

    /// Sends projection times camera as the view matrix.
    pub fn update_matrices(&mut self) {
        let view = matrix::multiply(&self.projection, &self.camera);
        self.call(&Call::ViewMatrix { m: flat(&view) });
    }

    /// Sends the model matrix.
    pub fn model(&mut self, model: &Matrix) {
        self.call(&Call::ModelMatrix { m: flat(model) });
    }
}

/// The sixteen elements of a matrix, row by row.
pub fn flat(m: &Matrix) -> [f32; 16] {
    std::array::from_fn(|i| m[i / 4][i % 4])
}
