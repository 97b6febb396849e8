#!/bin/sh
# run-suite.sh OUT [SECONDS=480]: measure Vitrine on this machine's own driver, and write JSON, text and PNG files into
# the folder OUT. It is part of the archive that scripts/bundle-gpu makes. It ends within SECONDS: each step has a limit
# of its own, and a step that is cut off leaves the results that it had. The most important steps come first.
# Then: tar cf results.tar -C OUT .
set -u
here=$(cd "$(dirname "$0")" && pwd)
[ $# -ge 1 ] || { echo "usage: run-suite.sh OUT [SECONDS=480]" >&2; exit 2; }
out=$1
limit=${2:-480}
case $limit in
  '' | *[!0-9]*) echo "run-suite.sh: SECONDS is a whole number, not '$limit'" >&2; exit 2 ;;
esac
start=$(date +%s)
mkdir -p "$out" || exit 2
out=$(cd "$out" && pwd)
log=$out/log.txt
: > "$log"

# --- The machine's libraries come first. Those of the archive stand in for missing ones.
has_library() {
  ldconfig -p 2>/dev/null | grep -q "[[:space:]]$1 " || ls /usr/lib/x86_64-linux-gnu/"$1" /usr/lib64/"$1" >/dev/null 2>&1
}
libraries=$here/lib
for library in libEGL.so.1 libGL.so.1 libGLX.so.0 libGLdispatch.so.0; do
  if ! has_library "$library"; then
    libraries=$libraries:$here/glvnd
    echo "glvnd: of the archive, since $library is missing" >> "$log"
    break
  fi
done
LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
if ! "$here/bin/vitrine" --version >/dev/null 2>&1; then
  LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$here/cxx
  echo "libstdc++: of the archive" >> "$log"
fi
if ! "$here/bin/vitrine" --version > "$out/version.txt" 2>&1; then
  cat "$out/version.txt" >&2
  exit 1
fi
# Containers often have NVIDIA's EGL without the file by which glvnd finds it.
if [ -z "${__EGL_VENDOR_LIBRARY_FILENAMES:-}" ] &&
  ! ls /usr/share/glvnd/egl_vendor.d/*nvidia* /etc/glvnd/egl_vendor.d/*nvidia* >/dev/null 2>&1; then
  vendor=$(ls /usr/local/nvidia/share/glvnd/egl_vendor.d/*nvidia*.json 2>/dev/null | head -n 1)
  library=$(ldconfig -p 2>/dev/null | sed -n 's/.*=> \(.*libEGL_nvidia.so.0\)$/\1/p' | head -n 1)
  [ -n "$library" ] ||
    library=$(find /usr/local/nvidia /usr/lib /usr/lib64 -name libEGL_nvidia.so.0 2>/dev/null | head -n 1)
  if [ -z "$vendor" ] && [ -n "$library" ]; then
    vendor=$out/nvidia_egl.json
    printf '{"file_format_version":"1.0.0","ICD":{"library_path":"%s"}}\n' "$library" > "$vendor"
  fi
  if [ -n "$vendor" ]; then
    __EGL_VENDOR_LIBRARY_FILENAMES=$vendor
    export __EGL_VENDOR_LIBRARY_FILENAMES
  fi
fi

# --- Steps
# A process that is cut off needs some seconds to end.
seconds_left() { echo $((limit - 6 - ($(date +%s) - start))); }

# step NAME SECONDS COMMAND...: run a command into OUT/NAME.txt, for so many seconds at most.
step() {
  name=$1
  most=$2
  shift 2
  left=$(seconds_left)
  if [ "$left" -le 3 ]; then
    echo "$name: left out, no time" >> "$log"
    return
  fi
  [ "$left" -lt "$most" ] && most=$left
  begin=$(date +%s)
  timeout -k 2 "$most" "$@" > "$out/$name.txt" 2>&1
  status=$?
  took="$(($(date +%s) - begin)) s"
  if [ $status -eq 124 ] || [ $status -eq 137 ]; then
    echo "$name: cut off after $took" >> "$log"
  else
    echo "$name: status $status, $took" >> "$log"
  fi
}

# compare NAME SECONDS ARGUMENT...: vitrine compare, with the results in OUT/NAME.json.
compare() {
  name=$1
  most=$2
  shift 2
  step "$name" "$most" "$here/bin/vitrine" compare "$@" --json "$out/$name.json"
}

# --- 1. The device
step device 20 sh -c "cat '$here/VERSION'; date -u; uname -a; nvidia-smi -L;
  nvidia-smi --query-gpu=driver_version,clocks.max.sm,memory.total --format=csv,noheader;
  echo LD_LIBRARY_PATH=\$LD_LIBRARY_PATH; echo VENDOR=\${__EGL_VENDOR_LIBRARY_FILENAMES:-};
  '$here/bin/describe_device'"
cp "$here/VERSION" "$out/"
if ! grep -q GL_RENDERER "$out/device.txt"; then
  tail -n 1 "$out/device.txt" >&2
  exit 2
fi
step report 30 "$here/bin/vitrine" report

# The paths that this device has: as it is, and without framebuffer fetch where it has that.
paths=as-it-is
if grep -q GL_EXT_shader_framebuffer_fetch "$out/device.txt"; then
  paths="as-it-is no-fetch"
fi
# on_path PATH FUNCTION ARGUMENT...: run a step with VITRINE_DEVICE set to the path.
on_path() {
  path=$1
  shift
  if [ "$path" = as-it-is ]; then
    "$@"
  else
    VITRINE_DEVICE=$path
    export VITRINE_DEVICE
    "$@"
    unset VITRINE_DEVICE
  fi
}

# --- 2. Right or wrong: all methods, small, with the driver's own messages
lists=linked-list,linked-list-compact,prefix-sum,prefix-sum-predicted,prefix-sum-predicted-compact
all=vtk-oit,$lists,stencil-routed,stencil-mask-8,vtk-peeling,truth
for path in $paths; do
  on_path "$path" step "exact-$path" 60 env "LD_PRELOAD=$here/bin/gl_recorder.so" \
    "GL_RECORD_ERRORS=$out/errors-$path.txt" "$here/bin/vitrine" compare demo:spheres,layers=16 --size 256x192 --frames 2 --methods "$all" \
    --json "$out/exact-$path.json"
done
compare exact-samples 30 demo:spheres,layers=16 --size 160x120 --frames 2 --multisamples 4 \
  --methods vtk-oit,linked-list,prefix-sum-predicted-compact

# --- 3. How long programs take to compile
step compile 90 "$here/bin/compile_shaders" "$here/shaders"

# --- 4. Stages at the users' sizes
timed=vtk-oit,$lists
frames=9
grep -q "GL_RENDERER: .*\(llvmpipe\|softpipe\|lavapipe\)" "$out/device.txt" && frames=2
stages() { # SIZE LAYERS PATH SECONDS
  on_path "$3" compare "stages-$1-$2-$3" "$4" "demo:spheres,layers=$2" --size "$1" --frames $frames --orbit 10 --stages \
    --without-truth --methods "$timed"
}
for layers in 8 32 64 16; do
  for path in $paths; do
    stages 1920x1080 $layers "$path" 30
  done
done
for layers in 8 32; do
  stages 3840x2160 $layers as-it-is 30
done

# --- 5. Scenes in which methods fail, lights, the culler
for scene in stack,layers=300 coincident impostors needles clipped; do
  compare "failing-$scene" 15 "demo:$scene" --size 257x131 --frames 2 --methods "vtk-oit,$lists,truth"
done
step lights 25 "$here/bin/vitrine" lights demo:hall,lights=256 --modes loop,tiled,clustered,clustered-deferred \
  --size 1920x1080 --frames 9 --json "$out/lights.json"
step cull 25 "$here/bin/vitrine" cull demo:assembly,parts=3000 --size 1920x1080 --poses 10 --json "$out/cull.json"
compare assembly 30 demo:assembly,parts=3000 --opacity 0.3 --size 1920x1080 --frames 9 --stages --without-truth \
  --methods "$timed,vtk-peeling"

# --- 6. Pictures, and the rest
for method in linked-list prefix-sum-predicted-compact vtk-oit; do
  step "picture-$method" 15 "$here/bin/vitrine" render demo:assembly,parts=300 --opacity 0.3 --size 640x360 \
    --method "$method" -o "$out/$method.png"
done
for layers in 128 256; do
  for path in $paths; do
    stages 1920x1080 $layers "$path" 40
  done
done
for layers in 16 64 128 256; do
  stages 3840x2160 $layers as-it-is 40
done
case $paths in
  *no-fetch*) for layers in 8 32; do stages 3840x2160 $layers no-fetch 30; done ;;
esac
step sorts 40 "$here/bin/vitrine" sorts --json "$out/sorts.json"
echo "total: $(($(date +%s) - start)) s of $limit s" >> "$log"
cat "$log"
