//! Shader scripts: text that says how a material is drawn, stage by stage.

use std::collections::HashMap;

use crate::math::Vec3;
use crate::wave::{Shape, Wave};

/// How a stage's pixels meet those that are there.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// They replace them.
    #[default]
    Opaque,
    /// They replace them where alpha is at least (or, negated, below) this.
    Tested {
        /// 1 to 255.
        reference: u8,
        /// Pixels below pass instead.
        below: bool,
    },
    /// They are blended: factors of source and destination, as Glide numbers
    /// them.
    Blended(i32, i32),
}

impl Mode {
    /// What is there is multiplied.
    pub fn is_filter(self) -> bool {
        matches!(self, Mode::Blended(2, 0) | Mode::Blended(0, 2))
    }
}

/// The picture of a stage.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Source {
    /// None was named.
    #[default]
    None,
    /// Files, shown in turn, so many a second.
    Pictures(Vec<String>, f32),
    /// The surface's lightmap.
    Lightmap,
    /// White.
    White,
}

/// Where a colour or alpha comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Gen {
    /// All of it.
    #[default]
    Identity,
    /// The vertices.
    Vertex,
    /// What the vertices lack of all.
    OneMinusVertex,
    /// Red, green, blue (or alpha in all of them), 0 to 1.
    Const(Vec3),
    /// A function of time, 0 to 1.
    Wave(Wave),
}

/// What moves texture coordinates, in the order of the script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Move {
    /// They are multiplied.
    Scale(f32, f32),
    /// They move so far in a second.
    Scroll(f32, f32),
    /// They turn around the middle, degrees a second.
    Rotate(f32),
    /// They are divided by a function of time, from the middle.
    Stretch(Wave),
    /// They swim: base, amplitude, phase, frequency.
    Turbulence(Wave),
    /// A matrix (s by s, s by t, t by s, t by t) and an offset.
    Transform([f32; 4], [f32; 2]),
}

/// What moves vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Deform {
    /// Each rectangle turns to the viewer.
    Sprite,
    /// Each rectangle turns around its longer axis.
    Axis,
    /// Along the normal by a function of time and place; the number says how
    /// much a place counts.
    Wave(f32, Wave),
    /// Along the normal by s: width, height, speed.
    Bulge(f32, f32, f32),
    /// All together along a direction.
    Move(Vec3, Wave),
}

/// One stage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stage {
    /// Its picture.
    pub source: Source,
    /// The picture is not repeated.
    pub clamp: bool,
    /// How it is drawn.
    pub mode: Mode,
    /// Colour that the picture is multiplied with.
    pub color: Gen,
    /// Alpha that the picture's is multiplied with.
    pub alpha: Gen,
    /// What moves its coordinates.
    pub moves: Vec<Move>,
    /// Coordinates are those of a reflection.
    pub environment: bool,
    /// It is multiplied with the lightmap in the same pass.
    pub lit: bool,
}

/// What a script says of the sky.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sky {
    /// First part of the names of the six pictures far away.
    pub far: Option<String>,
    /// Height of the clouds, which the stages are.
    pub clouds: f32,
}

/// What a script says of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shader {
    /// Its stages, the first one drawn first.
    pub stages: Vec<Stage>,
    /// What moves its vertices.
    pub deforms: Vec<Deform>,
    /// Both sides are seen.
    pub two_sided: bool,
    /// It is the sky.
    pub sky: Option<Sky>,
    /// It is not drawn.
    pub nodraw: bool,
}

impl Shader {
    /// A material without a script: its picture times the lightmap.
    pub fn picture(name: &str) -> Shader {
        let source = Source::Pictures(vec![name.to_string()], 0.0);
        let stage = Stage { source, lit: true, ..Stage::default() };
        Shader { stages: vec![stage], ..Shader::default() }
    }

    /// Joins a picture and a lightmap that start the material, whichever comes
    /// first, to one stage.
    fn join_lightmap(&mut self) {
        let [first, second, ..] = &self.stages[..] else { return };
        let plain = |stage: &Stage| stage.color == Gen::Identity && stage.alpha == Gen::Identity;
        let picture_first = second.source == Source::Lightmap
            && second.mode.is_filter()
            && plain(second)
            && first.source != Source::Lightmap
            && !matches!(first.mode, Mode::Blended(..));
        let light_first = first.source == Source::Lightmap
            && first.mode == Mode::Opaque
            && plain(first)
            && second.mode.is_filter()
            && second.source != Source::Lightmap;
        if picture_first {
            self.stages.remove(1);
            self.stages[0].lit = true;
        } else if light_first {
            self.stages.remove(0);
            (self.stages[0].lit, self.stages[0].mode) = (true, Mode::Opaque);
        }
    }
}

/// All materials of some scripts by name, in lower case.
pub type Shaders = HashMap<String, Shader>;

/// One line's words; braces are lines of their own.
fn lines(text: &str) -> Vec<Vec<&str>> {
    let mut out = Vec::new();
    for line in text.lines() {
        let line = line.split("//").next().unwrap_or_default();
        let mut words = Vec::new();
        for word in line.split_whitespace() {
            if word == "{" || word == "}" {
                out.push(core::mem::take(&mut words));
                out.push(vec![word]);
            } else if word != "(" && word != ")" {
                words.push(word);
            }
        }
        out.push(words);
    }
    out.retain(|words| !words.is_empty());
    out
}

/// The most stages of a material.
const MAX_STAGES: usize = 8;

/// Adds a script's materials; those that are there already are kept.
pub fn parse(text: &str, shaders: &mut Shaders) {
    let mut depth = 0;
    let mut name = String::new();
    let mut shader = Shader::default();
    let mut stage = Stage::default();
    for words in lines(text) {
        match (words[0], depth) {
            ("{", 0) => (depth, shader) = (1, Shader::default()),
            ("{", _) => (depth, stage) = (depth + 1, Stage::default()),
            ("}", 0) => {}
            ("}", 1) => {
                depth = 0;
                shader.join_lightmap();
                let finished = core::mem::take(&mut shader);
                shaders.entry(name.to_ascii_lowercase()).or_insert(finished);
            }
            ("}", _) => {
                depth -= 1;
                if stage.source != Source::None && shader.stages.len() < MAX_STAGES {
                    shader.stages.push(core::mem::take(&mut stage));
                }
            }
            (_, 0) => name = words[0].to_string(),
            (_, 1) => general(&mut shader, &words),
            _ => stage_line(&mut stage, &words),
        }
    }
}

fn is(word: Option<&&str>, expected: &str) -> bool {
    word.is_some_and(|word| word.eq_ignore_ascii_case(expected))
}

/// A number, 0 where there is none.
fn number(words: &[&str], at: usize) -> f32 {
    let parsed = words.get(at).and_then(|word| word.parse().ok());
    parsed.filter(|v: &f32| v.is_finite()).map_or(0.0, |v| v.clamp(-1e5, 1e5))
}

/// A function of time: its name, base, amplitude, phase, frequency.
fn wave(words: &[&str], at: usize) -> Wave {
    let shape = match words.get(at).map(|word| word.to_ascii_lowercase()).as_deref() {
        Some("triangle") => Shape::Triangle,
        Some("square") => Shape::Square,
        Some("sawtooth") => Shape::Sawtooth,
        Some("inversesawtooth") => Shape::InverseSawtooth,
        Some("noise") => Shape::Noise,
        _ => Shape::Sine,
    };
    swing(shape, words, at + 1)
}

fn swing(shape: Shape, words: &[&str], at: usize) -> Wave {
    let [base, amplitude, phase, frequency] = core::array::from_fn(|i| number(words, at + i));
    Wave { shape, base, amplitude, phase, frequency }
}

fn general(shader: &mut Shader, words: &[&str]) {
    let key = words[0].to_ascii_lowercase();
    let first = words.get(1);
    match key.as_str() {
        "surfaceparm" => {
            if is(first, "sky") {
                shader.sky.get_or_insert_default();
            }
            shader.nodraw |= is(first, "nodraw");
        }
        "skyparms" => {
            let far = first.filter(|name| **name != "-").map(|name| name.to_string());
            let clouds = if is(words.get(2), "-") { 0.0 } else { number(words, 2) };
            shader.sky = Some(Sky { far, clouds: if clouds > 0.0 { clouds } else { 512.0 } });
        }
        "cull" => {
            let both = ["none", "disable", "twosided"];
            shader.two_sided = both.iter().any(|word| is(first, word));
        }
        "deformvertexes" => shader.deforms.extend(deform(words)),
        _ => {}
    }
}

fn deform(words: &[&str]) -> Option<Deform> {
    Some(match words.get(1)?.to_ascii_lowercase().as_str() {
        "autosprite" => Deform::Sprite,
        "autosprite2" => Deform::Axis,
        "wave" => Deform::Wave(1.0 / number(words, 2).abs().max(0.01), wave(words, 3)),
        "bulge" => Deform::Bulge(number(words, 2), number(words, 3), number(words, 4)),
        "move" => Deform::Move(core::array::from_fn(|i| number(words, 2 + i)), wave(words, 5)),
        _ => return None,
    })
}

fn stage_line(stage: &mut Stage, words: &[&str]) {
    let key = words[0].to_ascii_lowercase();
    let first = words.get(1);
    match key.as_str() {
        "map" | "clampmap" => set_map(stage, first.copied(), key == "clampmap"),
        "animmap" if words.len() > 2 => {
            let files = words[2..].iter().map(|file| file.to_string()).collect();
            stage.source = Source::Pictures(files, number(words, 1));
        }
        "blendfunc" => stage.mode = blend(&words[1..]).unwrap_or(stage.mode),
        "alphafunc" => stage.mode = alpha_test(first.copied()).unwrap_or(stage.mode),
        "tcmod" => stage.moves.extend(tc_mod(words)),
        "tcgen" => stage.environment = is(first, "environment"),
        "rgbgen" => stage.color = generated(words, stage.color, true),
        "alphagen" => stage.alpha = generated(words, stage.alpha, false),
        _ => {}
    }
}

fn generated(words: &[&str], old: Gen, three: bool) -> Gen {
    match words.get(1).map(|word| word.to_ascii_lowercase()).as_deref() {
        Some("vertex" | "exactvertex") => Gen::Vertex,
        Some("oneminusvertex") => Gen::OneMinusVertex,
        Some("const" | "constant") => {
            Gen::Const(core::array::from_fn(|i| number(words, if three { 2 + i } else { 2 })))
        }
        Some("wave") => Gen::Wave(wave(words, 2)),
        Some(_) => Gen::Identity,
        None => old,
    }
}

fn tc_mod(words: &[&str]) -> Option<Move> {
    let value = |at: usize| number(words, at);
    Some(match words.get(1)?.to_ascii_lowercase().as_str() {
        "scale" => Move::Scale(value(2), value(3)),
        "scroll" => Move::Scroll(value(2), value(3)),
        "rotate" => Move::Rotate(value(2)),
        "stretch" => Move::Stretch(wave(words, 2)),
        // Some scripts name a function, which has always been a sine.
        "turb" => {
            let named = words.get(2).is_some_and(|word| word.parse::<f32>().is_err());
            Move::Turbulence(swing(Shape::Sine, words, 2 + usize::from(named)))
        }
        "transform" => {
            Move::Transform(core::array::from_fn(|i| value(2 + i)), [value(6), value(7)])
        }
        _ => return None,
    })
}

fn set_map(stage: &mut Stage, name: Option<&str>, clamp: bool) {
    let Some(name) = name else { return };
    stage.clamp = clamp;
    stage.source = match name.to_ascii_lowercase().as_str() {
        "$lightmap" => Source::Lightmap,
        "$whiteimage" | "*white" => Source::White,
        _ => Source::Pictures(vec![name.to_string()], 0.0),
    };
}

/// A factor as Glide numbers it.
fn factor(word: &str) -> Option<i32> {
    Some(match word.to_ascii_lowercase().as_str() {
        "gl_zero" => 0,
        "gl_src_alpha" => 1,
        "gl_src_color" | "gl_dst_color" => 2,
        "gl_dst_alpha" => 3,
        "gl_one" => 4,
        "gl_one_minus_src_alpha" => 5,
        "gl_one_minus_src_color" | "gl_one_minus_dst_color" => 6,
        "gl_one_minus_dst_alpha" => 7,
        _ => return None,
    })
}

fn blend(words: &[&str]) -> Option<Mode> {
    let (source, destination) = match words {
        [name] => match name.to_ascii_lowercase().as_str() {
            "add" => (4, 4),
            "filter" => (2, 0),
            "blend" => (1, 5),
            _ => return None,
        },
        [source, destination, ..] => (factor(source)?, factor(destination)?),
        [] => return None,
    };
    Some(if (source, destination) == (4, 0) {
        Mode::Opaque
    } else {
        Mode::Blended(source, destination)
    })
}

fn alpha_test(word: Option<&str>) -> Option<Mode> {
    let (reference, below) = match word?.to_ascii_lowercase().as_str() {
        "gt0" => (1, false),
        "lt128" => (128, true),
        "ge128" => (128, false),
        _ => return None,
    };
    Some(Mode::Tested { reference, below })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(text: &str) -> Shader {
        let mut shaders = Shaders::new();
        parse(text, &mut shaders);
        assert_eq!(shaders.len(), 1, "{shaders:?}");
        shaders.into_values().next().unwrap()
    }

    fn picture(stage: &Stage) -> &str {
        let Source::Pictures(files, _) = &stage.source else { panic!("{stage:?}") };
        &files[0]
    }

    #[test]
    fn pictures_and_lightmaps_are_joined_in_both_orders() {
        let light = "{\n map $lightmap\n rgbgen identity\n }\n";
        let rest = "{ map textures/a/c.tga\n blendfunc add\n } }";
        let shader = one(&format!(
            "textures/a/b // a wall\n{{\n surfaceparm nomarks\n {light} {{ map textures/a/b.tga\n \
             blendFunc GL_DST_COLOR GL_ZERO\n tcMod scale 2 4 }}\n {rest}"
        ));
        assert_eq!(shader.stages.len(), 2);
        let base = &shader.stages[0];
        assert_eq!((picture(base), base.mode, base.lit), ("textures/a/b.tga", Mode::Opaque, true));
        assert_eq!(base.moves, [Move::Scale(2.0, 4.0)]);
        assert_eq!(shader.stages[1].mode, Mode::Blended(4, 4));
        let shader =
            one("x\n{\n{\nmap x.tga\nalphaFunc GE128\n}\n{\nmap $lightmap\nblendfunc filter\n}\n}");
        assert_eq!(shader.stages.len(), 1);
        assert_eq!(shader.stages[0].mode, Mode::Tested { reference: 128, below: false });
        assert!(shader.stages[0].lit);
        // Something in between keeps them apart.
        let shader = one(
            "x\n{\n{\nmap e.tga\ntcgen environment\n}\n{\nmap x.tga\nblendfunc blend\n}\n{\nmap \
             $lightmap\nblendfunc filter\n}\n}",
        );
        assert_eq!(shader.stages.len(), 3);
        assert!(shader.stages[0].environment && shader.stages.iter().all(|stage| !stage.lit));
    }

    #[test]
    fn what_moves() {
        let shader = one(
            "x\n{\ncull none\ndeformVertexes autosprite\ndeformVertexes wave 100 sin 3 2 0 .1\n{\n\
             clampmap x.jpg\nblendfunc gl_one gl_one\ntcmod scroll .5 1\ntcmod rotate 30\ntcmod \
             turb 0 .1 0 2\ntcmod stretch sin 1 .2 0 1\nrgbGen wave triangle .5 .5 0 1\nalphagen \
             const .25\n}\n}",
        );
        let stage = &shader.stages[0];
        assert!(stage.clamp && shader.two_sided);
        assert_eq!(stage.moves.len(), 4);
        assert_eq!(stage.moves[0], Move::Scroll(0.5, 1.0));
        let Gen::Wave(wave) = stage.color else { panic!("{stage:?}") };
        assert_eq!((wave.shape, wave.base, wave.frequency), (Shape::Triangle, 0.5, 1.0));
        assert_eq!(stage.alpha, Gen::Const([0.25; 3]));
        assert_eq!(shader.deforms[0], Deform::Sprite);
        assert!(matches!(shader.deforms[1], Deform::Wave(spread, _) if spread == 0.01));
    }

    #[test]
    fn the_sky() {
        let shader = one("sky\n{\nskyparms env/x 300 -\nsurfaceparm sky\nsurfaceparm nodraw\n}");
        assert_eq!(shader.sky, Some(Sky { far: Some("env/x".into()), clouds: 300.0 }));
        assert!(shader.nodraw && shader.stages.is_empty());
        let shader = one("sky\n{\nsurfaceparm sky\nskyparms - - -\n{\nmap c.tga\n}\n}");
        assert_eq!(shader.sky, Some(Sky { far: None, clouds: 512.0 }));
        assert_eq!(shader.stages.len(), 1);
    }

    #[test]
    fn broken_scripts_end() {
        for text in [
            "{",
            "}",
            "a {",
            "a\n{\n{\n{\n}",
            "a\n{\n{\nmap\nblendfunc\ntcmod scale x\ntcmod turb\nrgbgen wave\n}}",
            "a\n{\ndeformvertexes\ndeformvertexes wave\nskyparms\n}",
        ] {
            parse(text, &mut Shaders::new());
        }
    }
}
