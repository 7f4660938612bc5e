# Names for the page of the program, which is written for other readers of Markdown, too.
s/^# canonical-pose$/# The Program canonical-pose {#Canonical_pose_3Program}/
s/^## glTF$/## glTF {#gltf}/
s/^## collection$/## collection: Many Shapes {#Canonical_pose_3ManyShapes}/
# Doxygen shows the backslash of a bar in code, and would take the bar alone for the end of a cell.
/^|/s/\\|/∣/g
