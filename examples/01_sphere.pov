// cargo run --release -- render examples/01_sphere.pov
//
// The smallest picture worth looking at: a camera, a light, a ball, and a floor to catch its shadow.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <0, 1.6, -5>
  look_at <0, 0.85, 0>
  right x * image_width / image_height
  angle 42
}

light_source { <-4, 6, -5> rgb 1 }
background { rgb <0.55, 0.7, 0.9> }

plane {
  y, 0
  pigment { checker rgb <0.85, 0.82, 0.75> rgb <0.35, 0.4, 0.45> }
  finish { reflection 0.08 }
}

sphere {
  <0, 1, 0>, 1
  pigment { rgb <0.85, 0.2, 0.12> }
  finish { phong 0.7 phong_size 60 reflection { 0.03, 0.4 } }
}
