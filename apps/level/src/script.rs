//! Shader scripts: text that says how a material is drawn. Of each, what one
//! pass on hardware of 1997 can show is kept: the first stage with a picture
//! of its own, how it is blended, and whether the surface is drawn at all.

use std::collections::HashMap;

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

/// What a script says of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shader {
    /// The picture's file name.
    pub map: Option<String>,
    /// The picture is not repeated.
    pub clamp: bool,
    /// How it is drawn.
    pub mode: Mode,
    /// Texture coordinates are multiplied by these.
    pub scale: [f32; 2],
    /// Coloured by the vertices.
    pub vertex_color: bool,
    /// Some stage shows the lightmap.
    pub lightmap: bool,
    /// Both sides are seen.
    pub two_sided: bool,
    /// It is the sky.
    pub sky: bool,
    /// It is not drawn.
    pub nodraw: bool,
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
            } else {
                words.push(word);
            }
        }
        out.push(words);
    }
    out.retain(|words| !words.is_empty());
    out
}

/// Adds a script's materials; those that are there already are kept.
pub fn parse(text: &str, shaders: &mut Shaders) {
    let mut depth = 0;
    let mut name = String::new();
    let mut shader = Shader::default();
    let mut stage = Shader::default();
    for words in lines(text) {
        match (words[0], depth) {
            ("{", 0) => {
                depth = 1;
                shader = Shader { scale: [1.0; 2], ..Shader::default() };
            }
            ("{", _) => {
                depth += 1;
                stage = Shader { scale: [1.0; 2], ..Shader::default() };
            }
            ("}", 0) => {}
            ("}", 1) => {
                depth = 0;
                shaders.entry(name.to_ascii_lowercase()).or_insert_with(|| shader.clone());
            }
            ("}", _) => {
                depth -= 1;
                finish_stage(&mut shader, &stage);
            }
            (_, 0) => name = words[0].to_string(),
            (_, 1) => general(&mut shader, &words),
            _ => stage_line(&mut stage, &words),
        }
    }
}

/// The first stage with a picture becomes the material.
fn finish_stage(shader: &mut Shader, stage: &Shader) {
    shader.lightmap |= stage.lightmap;
    if shader.map.is_none() && stage.map.is_some() {
        shader.map = stage.map.clone();
        shader.clamp = stage.clamp;
        // A stage that multiplies a lightmap before it is drawn as the base.
        let after_lightmap = shader.lightmap && !stage.lightmap;
        shader.mode = if after_lightmap { Mode::Opaque } else { stage.mode };
        shader.scale = stage.scale;
        shader.vertex_color = stage.vertex_color;
    }
}

fn is(word: Option<&&str>, expected: &str) -> bool {
    word.is_some_and(|word| word.eq_ignore_ascii_case(expected))
}

fn general(shader: &mut Shader, words: &[&str]) {
    let key = words[0].to_ascii_lowercase();
    let first = words.get(1);
    match key.as_str() {
        "surfaceparm" => {
            shader.sky |= is(first, "sky");
            shader.nodraw |= is(first, "nodraw");
        }
        "skyparms" => shader.sky = true,
        "cull" => {
            let both = ["none", "disable", "twosided"];
            shader.two_sided = both.iter().any(|word| is(first, word));
        }
        _ => {}
    }
}

fn stage_line(stage: &mut Shader, words: &[&str]) {
    let key = words[0].to_ascii_lowercase();
    match key.as_str() {
        "map" | "clampmap" => set_map(stage, words.get(1).copied(), key == "clampmap"),
        // Of moving pictures, the first one.
        "animmap" => set_map(stage, words.get(2).copied(), false),
        "blendfunc" => stage.mode = blend(&words[1..]).unwrap_or(stage.mode),
        "alphafunc" => stage.mode = alpha_test(words.get(1).copied()).unwrap_or(stage.mode),
        "tcmod" if is(words.get(1), "scale") => {
            let number = |at: usize| {
                words.get(at).and_then(|w| w.parse().ok()).filter(|v: &f32| v.is_finite())
            };
            if let (Some(s), Some(t)) = (number(2), number(3)) {
                stage.scale = [stage.scale[0] * s, stage.scale[1] * t];
            }
        }
        "rgbgen" => {
            stage.vertex_color = is(words.get(1), "vertex") || is(words.get(1), "exactvertex");
        }
        _ => {}
    }
}

fn set_map(stage: &mut Shader, name: Option<&str>, clamp: bool) {
    match name.map(str::to_ascii_lowercase).as_deref() {
        Some("$lightmap") => stage.lightmap = true,
        Some(name) if !name.starts_with('$') => {
            stage.map = Some(name.to_string());
            stage.clamp = clamp;
        }
        _ => {}
    }
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

    #[test]
    fn the_base_is_the_first_stage_with_a_picture() {
        let shader = one("textures/a/b // a wall\n{\n surfaceparm nomarks\n {\n map $lightmap\n \
             rgbgen identity\n }\n { map textures/a/b.tga\n blendFunc GL_DST_COLOR GL_ZERO\n \
             tcMod scale 2 4 }\n { map textures/a/c.tga\n blendfunc add\n } }");
        assert_eq!(shader.map.as_deref(), Some("textures/a/b.tga"));
        assert_eq!(shader.mode, Mode::Opaque);
        assert!(shader.lightmap && !shader.sky && !shader.nodraw);
    }

    #[test]
    fn scales_blends_and_tests() {
        let shader =
            one("x\n{\ncull none\n{\nclampmap x.jpg\nblendfunc gl_one gl_one\ntcmod scale \
             2 4\nrgbGen vertex\n}\n}");
        assert_eq!((shader.mode, shader.scale), (Mode::Blended(4, 4), [2.0, 4.0]));
        assert!(shader.clamp && shader.two_sided && shader.vertex_color);
        let shader = one("x\n{\n{\nmap x.tga\nalphaFunc GE128\n}\n}");
        assert_eq!(shader.mode, Mode::Tested { reference: 128, below: false });
        let shader = one("sky\n{\nskyparms env/x 512 -\nsurfaceparm sky\nsurfaceparm nodraw\n}");
        assert!(shader.sky && shader.nodraw && shader.map.is_none());
    }

    #[test]
    fn broken_scripts_end() {
        for text in ["{", "}", "a {", "a\n{\n{\n{\n}", "a\n{\n{\nmap\nblendfunc\ntcmod scale x\n}}"]
        {
            parse(text, &mut Shaders::new());
        }
    }
}
