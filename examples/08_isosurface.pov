// cargo run --release -- render examples/08_isosurface.pov
//
// Surfaces written as formulas: a gyroid cut to a ball, and a stone worn by noise.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <0, 2.6, -7.5>
  look_at <0, 0.9, 0>
  right x * image_width / image_height
  angle 42
}

light_source { <-6, 9, -6> rgb 1 }
light_source { <7, 3, -4> rgb <0.25, 0.3, 0.45> }
background { rgb <0.12, 0.13, 0.16> }
plane { y, 0 pigment { rgb <0.5, 0.48, 0.45> } finish { reflection { 0.02, 0.3 } } }

// The gyroid: a surface without end that divides space in two equal halves; here with some thickness.
isosurface {
  function { abs(sin(5 * x) * cos(5 * y) + sin(5 * y) * cos(5 * z) + sin(5 * z) * cos(5 * x)) - 0.35 }
  contained_by { sphere { 0, 1.2 } }
  max_gradient 9
  accuracy 0.0005
  rotate <20, 35, 0>
  translate <-1.4, 1.2, 0>
  texture { pigment { rgb <0.85, 0.62, 0.25> } finish { specular 0.8 roughness 0.02 metallic reflection { 0.1, 0.35 metallic } } }
}

#declare Noise = function { pattern { bozo } }
isosurface {
  function {
    sqrt(x * x + 1.6 * y * y + z * z) - 1
    - 0.35 * Noise(1.6 * x, 1.6 * y, 1.6 * z) - 0.12 * Noise(5 * x, 5 * y, 5 * z) - 0.03 * Noise(16 * x, 16 * y, 16 * z)
  }
  contained_by { box { -1.6, 1.6 } }
  max_gradient 4
  accuracy 0.0005
  scale 0.85
  translate <1.5, 0.85, 0.2>
  texture {
    pigment { granite color_map { [0 rgb <0.5, 0.46, 0.42>] [0.5 rgb <0.38, 0.35, 0.33>] [1 rgb <0.62, 0.6, 0.56>] } scale 0.7 }
    finish { diffuse 0.75 specular 0.05 }
  }
}
