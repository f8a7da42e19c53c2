// cargo run --release -- render examples/03_csg.pov
//
// Constructive solid geometry: dice are boxes met by a sphere, with pits taken out.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera {
  location <0.5, 4.2, -7.5>
  look_at <0.1, 0.75, 0>
  right x * image_width / image_height
  angle 36
}

light_source { <-6, 9, -5> rgb 1 area_light 1.5 * x, 1.5 * z, 5, 5 adaptive 1 }
light_source { <8, 6, -6> rgb <0.2, 0.22, 0.3> shadowless }

plane {
  y, 0
  pigment { wood color_map { [0 rgb <0.45, 0.26, 0.13>] [1 rgb <0.3, 0.16, 0.07>] } turbulence 0.06 scale 0.35 rotate <4, 86, 0> }
  finish { specular 0.15 reflection { 0.02, 0.15 } }
}

// A pit of white in the middle of the top; what cuts gives its texture to the cut.
#declare Pip = sphere { 0, 0.17 scale <1, 0.6, 1> translate y pigment { rgb 0.95 } finish { specular 0.3 } }

// The pips of one face: laid out on top, then turned to where the face is.
#macro Face(Number, Turn)
  #if (mod(Number, 2) = 1) object { Pip rotate Turn } #end
  #for (Sign, -1, 1, 2)
    #if (Number > 1) object { Pip translate Sign * <0.5, 0, 0.5> rotate Turn } #end
    #if (Number > 3) object { Pip translate Sign * <0.5, 0, -0.5> rotate Turn } #end
    #if (Number = 6) object { Pip translate Sign * <0.5, 0, 0> rotate Turn } #end
  #end
#end

#macro Die(Body, Turn, Place)
  difference {
    intersection {
      box { -1, 1 }
      sphere { 0, 1.42 }
    }
    union { Face(1, 0) Face(2, -90 * x) Face(3, 90 * z) Face(4, -90 * z) Face(5, 90 * x) Face(6, 180 * x) }
    pigment { rgb Body }
    finish { specular 0.6 roughness 0.015 reflection { 0.02, 0.25 } }
    rotate Turn
    translate y
    scale 0.8
    translate Place
  }
#end

Die(<0.75, 0.1, 0.08>, <0, -25, 0>, <-1.7, 0, 0.4>)
Die(<0.9, 0.87, 0.78>, <0, 40, 90>, <1.1, 0, 0.9>)
Die(<0.12, 0.25, 0.5>, <90, 65, 0>, <0.1, 0, -1.9>)
