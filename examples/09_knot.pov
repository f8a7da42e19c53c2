// cargo run --release -- render examples/09_knot.pov
//
// A trefoil knot of brushed metal: one sphere_sweep through points on the curve, with mirrors around it.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }

camera {
  location <0, 5.5, -8.5>
  look_at <0, 0.7, 0>
  right x * image_width / image_height
  angle 36
}

light_source { <-6, 10, -6> rgb <1, 0.95, 0.9> }
light_source { <8, 5, 2> rgb <0.3, 0.35, 0.5> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.35, 0.32, 0.35>] [0.5 rgb <0.12, 0.14, 0.22>] [1 rgb <0.6, 0.65, 0.75>] } } }

plane {
  y, 0
  pigment { hexagon rgb <0.14, 0.15, 0.18> rgb <0.18, 0.19, 0.22> rgb <0.1, 0.11, 0.14> scale 0.6 }
  finish { reflection { 0.05, 0.5 falloff 2 } specular 0.2 }
}

#macro Knot(T) <sin(T) + 2 * sin(2 * T), 0.55 * sin(3 * T), cos(T) - 2 * cos(2 * T)> * 0.75 #end
#declare Steps = 30;
sphere_sweep {
  cubic_spline
  Steps + 3
  #for (K, -1, Steps + 1)
    , Knot(2 * pi * K / Steps), 0.26 + 0.05 * sin(6 * pi * K / Steps)
  #end
  tolerance 0.0001
  translate 0.85 * y
  texture {
    pigment { radial frequency 3 color_map { [0 rgb <0.95, 0.7, 0.35>] [0.5 rgb <0.9, 0.45, 0.35>] [1 rgb <0.95, 0.7, 0.35>] } }
    finish { diffuse 0.35 specular 0.9 roughness 0.03 metallic reflection { 0.25, 0.6 metallic } }
  }
}

// Small glass beads, one for each crossing of the curve with its own shadow.
#for (K, 0, 5)
  sphere {
    <2.75, 0.22, 0>, 0.22
    rotate (60 * K + 20) * y
    pigment { rgbf <0.8, 0.9, 1, 0.9> }
    finish { phong 0.8 reflection { 0, 1 fresnel } }
    interior { ior 1.5 }
  }
#end
