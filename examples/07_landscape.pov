// cargo run --release -- render examples/07_landscape.pov
//
// Hills from a height_field whose heights are a function, a lake, ground fog, and a painted sky.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <0.1, 0.75, -2.1>
  look_at <0.1, 0.42, 0.5>
  right x * image_width / image_height
  angle 52
}

light_source { <-60, 35, -10> * 100 rgb <1.15, 0.95, 0.7> }

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.85, 0.6, 0.4>] [0.12 rgb <0.5, 0.52, 0.6>] [0.5 rgb <0.15, 0.28, 0.55>] [1 rgb <0.05, 0.12, 0.35>] } }
  pigment {
    bozo
    turbulence 0.7
    octaves 5
    color_map { [0 rgbt 1] [0.5 rgbt 1] [0.65 rgbt <0.9, 0.7, 0.55, 0.5>] [0.85 rgbt <0.85, 0.7, 0.62, 0.2>] [1 rgbt <0.5, 0.45, 0.5, 0.1>] }
    scale <0.6, 0.18, 0.6>
    translate <0.3, 0, 0.1>
  }
}

// Ridges: folds of noise, each octave half as high and twice as fine as the one before.
#declare Noise = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } scale 0.35 translate <3.1, 0, 7.7> } }
#declare Ridge = function(x, y) { 1 - abs(2 * Noise(x, y, 0).red - 1) }
#declare Height = function {
  pow(Ridge(x, y), 2) * 0.55 + Ridge(2.1 * x, 2.1 * y + 3) * 0.22 + Ridge(4.3 * x + 1, 4.3 * y) * 0.1
  + Ridge(9.1 * x, 9.1 * y) * 0.045 + Ridge(19 * x, 19 * y) * 0.02
}

height_field {
  function 400, 400 { min(0.999, max(0, (Height(x, y, 0) - 0.25) * 1.1)) }
  smooth
  texture {
    slope { y, 0.5, 1 altitude y, 0, 0.9 }
    texture_map {
      [0.3 pigment { granite color_map { [0 rgb <0.45, 0.38, 0.33>] [1 rgb <0.25, 0.2, 0.18>] } scale 0.2 }]
      [0.55 pigment { bozo color_map { [0 rgb <0.3, 0.36, 0.16>] [1 rgb <0.2, 0.28, 0.1>] } scale 0.02 }]
      [0.72 pigment { rgb <0.45, 0.4, 0.33> }]
      [0.8 pigment { rgb <0.95, 0.95, 1> } finish { diffuse 0.8 }]
    }
  }
  scale <4, 1, 4>
  translate <-2, -0.12, -1.4>
}

plane {
  y, 0.17
  pigment { rgb <0.06, 0.16, 0.2> }
  normal { bumps 0.04 scale <0.05, 0.05, 0.015> }
  finish { reflection { 0.1, 0.9 falloff 4 } specular 0.4 roughness 0.005 }
}

fog { fog_type 2 distance 6 fog_offset 0.16 fog_alt 0.07 color rgb <0.6, 0.5, 0.45> }
