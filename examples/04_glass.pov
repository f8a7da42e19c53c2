// cargo run --release -- render examples/04_glass.pov
//
// Glass: refraction, coloured shadows, fading with depth, and a highlight that gathers in the shadow.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 12 }

camera {
  location <0, 3.4, -8>
  look_at <0.15, 0.8, 0>
  right x * image_width / image_height
  angle 40
}

light_source { <5, 9, 3> rgb 1.1 }
light_source { <-6, 5, -8> rgb 0.25 shadowless }

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.95, 0.9, 0.85>] [0.35 rgb <0.45, 0.6, 0.85>] [1 rgb <0.1, 0.2, 0.5>] } }
}
plane {
  y, 0
  pigment { checker rgb <0.92, 0.9, 0.86> rgb <0.55, 0.6, 0.66> scale 0.8 translate <0.1, 0.5, 0.2> }
}

#declare Polished = finish { ambient 0 diffuse 0.05 specular 0.9 roughness 0.003 reflection { 0, 1 fresnel } conserve_energy }
#macro Glass(Tint)
  material {
    texture { pigment { rgbf <1, 1, 1, 0.97> } finish { Polished } }
    interior { ior 1.52 fade_distance 0.9 fade_power 1001 fade_color rgb Tint caustics 0.5 }
  }
#end

// A ball, a bowl, and a block with a bubble in it.
sphere { <-1.9, 0.9, 0.6>, 0.9 Glass(<0.6, 0.85, 0.95>) }
difference {
  sphere { 0, 1 }
  sphere { <0, 0.15, 0>, 0.85 }
  plane { -y, -0.45 }
  translate <0.55, 1, 1>
  Glass(<0.55, 0.9, 0.6>)
}
difference {
  superellipsoid { <0.15, 0.15> scale <0.75, 0.75, 0.75> }
  sphere { 0, 0.45 }
  rotate 30 * y
  translate <2.1, 0.75, -0.6>
  Glass(<0.95, 0.6, 0.35>)
}
torus { 0.5, 0.17 translate <-0.35, 0.17, -1.6> Glass(<0.9, 0.45, 0.55>) }
