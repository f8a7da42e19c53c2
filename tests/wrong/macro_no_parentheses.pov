// A macro called without its parentheses.
#macro Floor() plane { y, 0 } #end
Floor
sphere { 0, 1 }
