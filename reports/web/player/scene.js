// SPDX-License-Identifier: GPL-3.0-or-later
// One recording in one canvas. Draws only when told to: a page at rest costs nothing.
import {
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { make_bodies } from "./bodies.js";
import { make_contacts } from "./contacts.js";
import { make_plane } from "./plane.js";

/**
 * `view`: as playback.js gives it; `colours` by name as plots/palette.js has them. Throws when there
 * is no WebGL. Gives {show({positions, contacts, up}), set({forces, contacts}), zoomable(yes), resize(),
 * look_like(other), on_look(listener), positions(), dispose()}.
 */
export function make_scene(canvas, recording, view, colours) {
  if (!canvas.getContext("webgl2")) throw new Error("there is no WebGL");
  const renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
  renderer.setPixelRatio(Math.min(2, globalThis.devicePixelRatio || 1));
  const { radius } = view;
  const centre = new Vector3(...view.centre);

  const scene = new Scene();
  scene.add(new HemisphereLight(0xffffff, new Color(colours.$muted), 2.2));
  const sun = new DirectionalLight(0xffffff, 1.8);
  sun.position.set(-1, -2, 3);
  scene.add(sun);

  const bodies = make_bodies(recording.bodies, colours);
  const contacts = make_contacts(radius, view.force, colours);
  // The recorded world, turned about the centre so that gravity points down.
  const world = new Group().add(
    bodies.group,
    contacts.group,
    ...recording.planes.map((plane) => make_plane(plane, centre, radius, colours)),
  );
  world.position.copy(centre).negate();
  const upright = new Group().add(world);
  upright.position.copy(centre);
  scene.add(upright);
  const [sky, up_now] = [new Vector3(0, 0, 1), new Vector3()];

  const camera = new PerspectiveCamera(35, 1, radius / 100, radius * 100);
  camera.up.set(0, 0, 1);
  camera.position
    .copy(centre)
    .add(new Vector3(-0.9, -2.6, 1.3).normalize().multiplyScalar(2.9 * radius));
  const controls = new OrbitControls(camera, canvas);
  controls.target.copy(centre);
  controls.enableZoom = false; // until the player is focused: the wheel scrolls the page
  canvas.style.touchAction = "pan-y";
  controls.update();

  const render = () => renderer.render(scene, camera);
  const listeners = [];
  controls.addEventListener("change", () => {
    render();
    for (const listener of listeners) listener();
  });

  return {
    show({ positions, contacts: list, up }) {
      bodies.show(positions);
      contacts.show(list);
      upright.quaternion.setFromUnitVectors(up_now.set(...up).normalize(), sky);
      render();
    },
    set({ forces, contacts: shown }) {
      contacts.set(forces, shown);
      render();
    },
    zoomable: (yes) => (controls.enableZoom = yes),
    resize(width, height) {
      renderer.setSize(width, height, false);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      render();
    },
    // The camera of another pane, without telling it back.
    look_like(other) {
      camera.position.copy(other.camera.position);
      camera.quaternion.copy(other.camera.quaternion);
      controls.target.copy(other.target);
      render();
    },
    on_look: (listener) => listeners.push(listener),
    camera,
    target: controls.target,
    positions: bodies.positions,
    dispose() {
      controls.dispose();
      renderer.dispose();
      renderer.forceContextLoss(); // a browser gives only so many
    },
  };
}
