//! Every name of the document exists in the header. Values, types and order of
//! members are checked by the compiler: `tests/c/quark_names.cpp`.

/// The header that programs include.
const HEADER: &str = include_str!("../../../../include/quark.h");

/// Source: QK, in the document's order.
const NAMES: &[(&str, &[&str])] = &[
    (
        "macros",
        &[
            "SCR_X",
            "SCR_Y",
            "GD_BITS",
            "RD_BITS",
            "GR_BITS",
            "BL_BITS",
            "COLOR_RGB",
            "COLOR_I",
            "CLIPZ_NEAR",
            "CLIPZ_FAR",
            "UV_MUL",
            "INVTBL_SHIFT",
            "ANGLE_SHIFT",
            "ANGLE2PI",
            "DEGREE",
            "TRIGO_SHIFT",
            "TRIGO_MUL",
        ],
    ),
    ("eDrawMode", &["DRAW_OPAQUE", "DRAW_KEYED", "DRAW_ALPHA", "DRAW_ALPHAKEYED"]),
    ("eTriangleMode", &["TRI_NZC", "TRI_ZC", "TRI_UT", "TRI_WF"]),
    (
        "eErrorCode",
        &[
            "ERR_NONE",
            "ERR_MEM",
            "ERR_TMEM",
            "ERR_UV",
            "ERR_VFMT",
            "ERR_IFMT",
            "ERR_DUPI",
            "ERR_DUPUV",
            "ERR_F32",
        ],
    ),
    ("CTexture", &["SizeX", "SizeY", "Texels", "DrawMaskX", "DrawMaskY", "Init"]),
    (
        "TRasterState",
        &["DrawMode", "DrawColor", "DrawIntensity", "TestCulling", "ZSort", "al", "Texture"],
    ),
    ("TVertex", &["x", "y", "z", "m", "i", "u", "v"]),
    ("eVextexFormat", &["VF_XYZ", "VF_I", "VF_UV"]),
    ("eIndexFormat", &["IF_ABC", "IF_I", "IF_C", "IF_UV"]),
    (
        "CTriangleList",
        &[
            "VertexList",
            "VertexListSize",
            "VertexStride",
            "IndexList",
            "IndexListSize",
            "IndexStride",
            "VuOfs",
            "ViOfs",
            "IuOfs",
            "IiOfs",
            "IcOfs",
            "State",
            "CmdMin",
            "CmdList",
            "CmdListSize",
            "ErrorCode",
            "Init",
            "WeldVertex",
            "BuildCmdList",
            "BuildFNormalList",
            "BuildVNormalList",
            "Delete",
            "SetABC",
            "SetXYZ",
            "SetUV",
            "SetI",
            "SetC",
            "GetABC",
            "GetXYZ",
            "GetUV",
            "GetI",
            "GetC",
        ],
    ),
    (
        "SINUS",
        &["COSINUS", "Sqrti", "Atan2i", "Log2", "ConvertUv", "Normalize", "DefUNormal", "Itoa"],
    ),
    (
        "CMatrix",
        &[
            "m",
            "LoadIdentity",
            "Load",
            "Mult",
            "Translate",
            "RotateX",
            "RotateY",
            "RotateZ",
            "Scale",
            "TransformVector",
            "RotateVector",
            "InvRotateVector",
            "Pos",
            "Dir",
            "Up",
            "Right",
        ],
    ),
    (
        "CVGpu",
        &[
            "TextState",
            "LineState",
            "SpriteState",
            "TriangleState",
            "TriangleMode",
            "Zoom",
            "ClipNear",
            "ClipFar",
            "NFrustrum",
            "ViewMatrix",
            "FrameCounter",
            "FrameBuffer",
            "Init",
            "Delete",
            "SetWorkMemory",
            "PrintXY",
            "PrintFps",
            "PutPixel",
            "DrawLine",
            "DrawSprite",
            "DrawSpriteScale",
            "DrawSpriteScaleZb",
            "DrawTriangle",
            "DrawTriangleList",
            "SortReset",
            "SortDraw",
            "FlushFB",
            "SetFov",
            "ScrProjection",
            "SetNFClip",
            "ClipMsk",
            "CrossFrustrum",
            "ZcErrorMax",
        ],
    ),
];

/// The text of a class, struct or enum; the whole header for other groups.
fn scope(group: &str) -> &'static str {
    let starts = ["class ", "struct ", "enum "].map(|kind| format!("{kind}{group}\n{{"));
    let Some(start) = starts.iter().find_map(|start| HEADER.find(start.as_str())) else {
        return HEADER;
    };
    let end = HEADER[start..].find("\n}").expect("a scope ends");
    &HEADER[start..start + end]
}

fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

#[test]
fn every_documented_name_is_in_the_header() {
    let mut count = 0;
    for (group, names) in NAMES {
        assert!(*group == "macros" || words(HEADER).any(|word| word == *group), "{group}");
        for name in *names {
            assert!(words(scope(group)).any(|word| word == *name), "{group}: {name}");
            count += 1;
        }
    }
    assert!(count >= 150, "{count}");
    // Both spellings of the processor's class.
    assert!(words(HEADER).any(|word| word == "CVgpu"));
}
