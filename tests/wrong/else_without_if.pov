// An #else without an #if.
#else
  sphere { 0, 1 }
#end
