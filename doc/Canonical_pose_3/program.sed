# Names for the page of the program, which other readers of Markdown also read.
s/^# canonical-pose$/# The Program canonical-pose {#Canonical_pose_3Program}/
s/^## glTF$/## glTF {#gltf}/
s/^## Stances$/## Stances {#stances}/
s/^## Report$/## Report {#report}/
s/^## collection$/## collection: Many Shapes {#Canonical_pose_3ManyShapes}/
# Doxygen shows the backslash of a bar in code, and would take the bar alone for the end of a cell.
/^|/s/\\|/∣/g
