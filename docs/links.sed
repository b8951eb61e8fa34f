# For Doxygen: links that work in the repository work in its pages too. A header has a page of its
# own there; any other file is opened where it lies, as seen from build/docs/html.
s,\]\((\.\./)?((mesh|shading|raster|render)/[a-z0-9_]+\.h)\),](@ref \2),g
s,\]\(\.\./([a-z0-9_/-]+\.[a-z]+)\),](../../../\1),g
