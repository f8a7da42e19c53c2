// A macro called with another spelling.
#version 3.7;
#macro Tree(H) cylinder { 0, H*y, .1 } #end
tree(3)
