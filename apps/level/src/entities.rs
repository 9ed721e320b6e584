//! The entities' text: blocks of quoted keys and values.

use crate::math::Vec3;

/// One entity: its pairs of key and value.
pub type Entity = Vec<(String, String)>;

/// All entities of a level.
pub fn parse(text: &str) -> Vec<Entity> {
    let mut entities = Vec::new();
    for block in text.split('{').skip(1) {
        let block = block.split('}').next().unwrap_or_default();
        // Every second piece between quotes is a string.
        let strings: Vec<&str> = block.split('"').skip(1).step_by(2).collect();
        let pairs = strings.as_chunks::<2>().0.iter();
        entities.push(pairs.map(|[key, value]| ((*key).into(), (*value).into())).collect());
    }
    entities
}

/// The value of a key.
pub fn value<'a>(entity: &'a Entity, key: &str) -> Option<&'a str> {
    entity.iter().find(|(k, _)| k.eq_ignore_ascii_case(key)).map(|(_, value)| value.as_str())
}

/// Where players of a match start: position, and direction in degrees.
pub fn spawn_points(entities: &[Entity]) -> Vec<(Vec3, f32)> {
    let is_spawn = |entity: &&Entity| {
        value(entity, "classname").is_some_and(|name| name == "info_player_deathmatch")
    };
    let spawn = |entity: &Entity| {
        let mut numbers = value(entity, "origin")?.split_whitespace().map(str::parse);
        let mut next = || numbers.next().and_then(Result::ok).filter(|v: &f32| v.is_finite());
        let origin = [next()?, next()?, next()?];
        let angle = value(entity, "angle").and_then(|a| a.parse().ok()).unwrap_or(0.0);
        Some((origin, angle))
    };
    entities.iter().filter(is_spawn).filter_map(spawn).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spawn_points_are_found() {
        let text = "{\n\"classname\" \"worldspawn\"\n}\n{\n\"origin\" \"1 -2 3.5\"\n\
                    \"angle\" \"90\"\n\"classname\" \"info_player_deathmatch\"\n}\n{ \"classname\" \
                    \"info_player_deathmatch\" \"origin\" \"4 x\" }";
        let entities = parse(text);
        assert_eq!(entities.len(), 3);
        assert_eq!(spawn_points(&entities), [([1.0, -2.0, 3.5], 90.0)]);
    }
}
