// cargo run --release -- render examples/02_transforms.pov
//
// One brick, placed two hundred times: a loop, three transforms, and a colour that goes round with them.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <0, 9.5, -13>
  look_at <0, 2.4, 0>
  right x * image_width / image_height
  angle 41
}

light_source { <-12, 18, -10> rgb <1, 0.95, 0.85> }
light_source { <15, 10, -8> rgb <0.15, 0.2, 0.35> }
background { rgb <0.08, 0.1, 0.16> }

plane { y, 0 pigment { rgb <0.3, 0.32, 0.36> } }

#declare Brick = difference {
  box { <-0.5, 0, -0.22>, <0.5, 0.24, 0.22> }
  cylinder { <-0.22, 0.16, 0>, <-0.22, 1, 0>, 0.12 }
  cylinder { <0.22, 0.16, 0>, <0.22, 1, 0>, 0.12 }
}

#declare Count = 200;
#for (K, 0, Count - 1)
  #declare T = K / Count;
  object {
    Brick
    rotate 90 * y
    translate <0.9 + 3.2 * pow(1 - T, 1.3), 0, 0>   // Out from the axis, less and less.
    rotate K * 17 * y                               // Around it.
    translate 5.2 * pow(T, 1.2) * y                 // And up.
    pigment { rgb <0.95, 0.75 - 0.55 * T, 0.25 + 0.15 * sin(T * 2 * pi)> }
    finish { specular 0.25 roughness 0.03 }
  }
#end
sphere { <0, 5.75, 0>, 0.45 pigment { rgb <0.95, 0.9, 0.7> } finish { reflection 0.3 phong 0.8 } }
