package org.urbi.sim.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.urbi.sim.SimulationException;
import org.urbi.sim.geometry.Pose;
import org.urbi.sim.geometry.Rotation;
import org.urbi.sim.geometry.Shape;
import org.urbi.sim.geometry.Vec3;

class RendererTest {
  private static final Lens LENS = new Lens(320, 240, Math.PI / 2, 0.02, 100);
  private static final Colour RED = new Colour(1, 0, 0);
  private static final Colour GREEN = new Colour(0, 1, 0);

  /** Full ambient light: every surface has its own colour. */
  private static byte[] flat(Pose camera, Lens lens, SceneObject... things) {
    return new Renderer()
        .render(new Scene(List.of(things), List.of(), 1, Colour.BLACK), camera, lens);
  }

  private static SceneObject thing(Shape shape, Pose pose, Colour colour) {
    return new SceneObject(shape, pose, Appearance.of(colour));
  }

  /** Where the pixels of a channel are: mean column, mean row, how many. */
  private static double[] blob(byte[] rgb, int width, int channel) {
    double x = 0;
    double y = 0;
    double count = 0;
    for (int i = 0; i < rgb.length / 3; i++) {
      if ((rgb[3 * i + channel] & 255) > 127) {
        x += i % width;
        y += i / width;
        count++;
      }
    }
    return new double[] {x / count, y / count, count};
  }

  @Test
  void sphereIsWhereProjectionPutsIt() {
    // 160 pixels of focal length: y = -1 of 4 is 40 pixels to the right, z = 0.5 is 20 upwards.
    Pose place = Pose.at(4, -1, 0.5);
    double[] blob = blob(flat(Pose.ORIGIN, LENS, thing(new Shape.Sphere(0.5), place, RED)), 320, 0);
    // A sphere off the axis is an ellipse, of which the middle is a little farther out.
    assertEquals(159.5 + 40, blob[0], 1);
    assertEquals(119.5 - 20, blob[1], 1);
    // The contour is a cone that meets the plane of the image in an ellipse of that area.
    double l2 = 16 + 1 + 0.25;
    double solid = 0.25;
    double area = Math.PI * 160 * 160 * solid * Math.sqrt(l2 - solid) / Math.pow(16 - solid, 1.5);
    assertEquals(area, blob[2], area * 0.02);
  }

  @Test
  void cameraIsPlacedAndTurned() {
    Pose camera = new Pose(new Vec3(1, 1, 1), Rotation.rollPitchYaw(0, 0, Math.PI / 2));
    double[] blob =
        blob(
            flat(camera, LENS, thing(new Shape.Box(0.2, 0.2, 0.2), Pose.at(1, 3, 1), RED)), 320, 0);
    assertEquals(159.5, blob[0], 0.6);
    assertEquals(119.5, blob[1], 0.6);
    // The front face is 0.2 m at 1.9 m.
    double edge = 0.2 / 1.9 * 160;
    assertEquals(edge * edge, blob[2], 2 * edge);
  }

  @Test
  void nearerHidesFarther() {
    SceneObject near = thing(new Shape.Box(0.1, 1, 1), Pose.at(2, 0, 0), RED);
    SceneObject far = thing(new Shape.Box(0.1, 2, 2), Pose.at(3, 0, 0), GREEN);
    byte[] one = flat(Pose.ORIGIN, LENS, near, far);
    assertArrayEquals(one, flat(Pose.ORIGIN, LENS, far, near));
    int middle = 3 * (120 * 320 + 160);
    assertEquals(255, one[middle] & 255);
    assertEquals(0, one[middle + 1] & 255);
    assertTrue(blob(one, 320, 1)[2] > 1000);
  }

  @Test
  void cylinderAndCapsuleHaveTheirOutlines() {
    Rotation lying = Rotation.about(Vec3.Y, Math.PI / 2);
    // Seen end on, a cylinder is a disc; the near lid is at 1.9 m.
    double[] disc =
        blob(
            flat(
                Pose.ORIGIN,
                LENS,
                thing(new Shape.Cylinder(0.2, 0.2), new Pose(new Vec3(2, 0, 0), lying), RED)),
            320,
            0);
    double radius = 0.2 / 1.9 * 160;
    assertEquals(Math.PI * radius * radius, disc[2], 0.02 * disc[2]);
    double[] standing =
        blob(
            flat(Pose.ORIGIN, LENS, thing(new Shape.Cylinder(0.1, 1), Pose.at(2, 0, 0), RED)),
            320,
            0);
    double[] domed =
        blob(
            flat(Pose.ORIGIN, LENS, thing(new Shape.Capsule(0.1, 1), Pose.at(2, 0, 0), RED)),
            320,
            0);
    double half = 0.1 / 2 * 160;
    assertEquals(2 * half * 1 / 1.9 * 160, standing[2], 0.05 * standing[2]);
    // The domes are tangent to a line of that slope; the rims below are nearest at 1.9 m.
    double slope = Math.tan(Math.atan(0.25) + Math.asin(0.1 / Math.sqrt(4.25)));
    double height = 160 * (slope - 0.5 / 1.9);
    assertEquals(Math.PI * half * height, domed[2] - standing[2], 16);
  }

  @Test
  void groundEndsAtTheHorizon() {
    SceneObject ground = thing(new Shape.Plane(), Pose.ORIGIN, GREEN);
    byte[] picture = flat(Pose.at(0, 0, 1), LENS, ground);
    // Down to 100 m the slope is 0.01, of 160 pixels: 1.6 below the middle.
    assertEquals(0, picture[3 * (120 * 320) + 1]);
    assertEquals(255, picture[3 * (122 * 320) + 1] & 255);
    assertEquals(0, blob(flat(Pose.at(0, 0, -1), LENS, ground), 320, 1)[2], "from below");
  }

  @Test
  void objectsThatReachBehindTheCameraAreDrawn() {
    SceneObject wall = thing(new Shape.Box(20, 0.1, 20), Pose.at(0, 1, 0), RED);
    double[] blob = blob(flat(Pose.ORIGIN, LENS, wall), 320, 0);
    assertTrue(blob[0] < 100 && blob[2] > 5000, "the wall on the left");
    SceneObject behind = thing(new Shape.Sphere(0.5), Pose.at(-3, 0, 0), RED);
    assertEquals(0, blob(flat(Pose.ORIGIN, LENS, behind), 320, 0)[2]);
  }

  @Test
  void lightFollowsTheCosine() {
    SceneObject plate = thing(new Shape.Box(0.1, 2, 2), Pose.at(2, 0, 0), Colour.WHITE);
    for (double angle : new double[] {0, 0.5, 1, 2}) {
      Vec3 direction = new Vec3(Math.cos(angle), Math.sin(angle), 0);
      Scene scene =
          new Scene(
              List.of(plate),
              List.of(new Light.Sun(direction, new Colour(0.8, 0.4, 0))),
              0.1,
              Colour.BLACK);
      byte[] rgb = new Renderer().render(scene, Pose.ORIGIN, LENS);
      int middle = 3 * (120 * 320 + 160);
      double cosine = Math.max(0, Math.cos(angle));
      assertEquals(255 * (0.1 + 0.8 * cosine), rgb[middle] & 255, 1);
      assertEquals(255 * (0.1 + 0.4 * cosine), rgb[middle + 1] & 255, 1);
      assertEquals(255 * 0.1, rgb[middle + 2] & 255, 1);
    }
  }

  @Test
  void picturesAreTheSameEverywhere() {
    Scene scene =
        new Scene(
            List.of(
                new SceneObject(
                    new Shape.Plane(),
                    Pose.ORIGIN,
                    new Appearance(Colour.WHITE, Colour.GREY, 0.3, 0, 0)),
                new SceneObject(
                    new Shape.Sphere(0.4),
                    Pose.at(2, 0.3, 0.4),
                    new Appearance(RED, null, 1, 0.5, 0)),
                thing(
                    new Shape.Box(0.5, 0.4, 0.3),
                    new Pose(new Vec3(2.5, -0.6, 0.3), Rotation.rollPitchYaw(0.3, 0.2, 0.7)),
                    GREEN),
                thing(
                    new Shape.Capsule(0.1, 0.5),
                    new Pose(new Vec3(1.5, -0.4, 0.5), Rotation.rollPitchYaw(1, 0, 0)),
                    GREEN)),
            List.of(
                new Light.Sun(new Vec3(1, 1, -2), new Colour(0.5, 0.5, 0.4)),
                new Light.Lamp(new Vec3(0, 0, 2), new Colour(0.2, 0.2, 0.3))),
            0.3,
            new Colour(0.5, 0.6, 0.9));
    CRC32 sum = new CRC32();
    Renderer renderer = new Renderer();
    sum.update(renderer.render(scene, Pose.at(0, 0, 0.6), LENS));
    sum.update(renderer.render(scene, Pose.at(0, 0, 0.6), LENS.resized(160, 120)));
    assertEquals(GOLDEN, sum.getValue());
  }

  private static final long GOLDEN = 1899016677L;

  @Test
  void impossibleLensesAreRefused() {
    assertEquals(
        "size: between 1 and 4096 pixels expected, not 0x240",
        assertThrows(SimulationException.class, () -> LENS.resized(0, 240)).getMessage());
    assertThrows(SimulationException.class, () -> new Lens(320, 240, Double.NaN, 0.1, 10));
    assertThrows(SimulationException.class, () -> new Lens(320, 240, 1, 10, 0.1));
    assertEquals(2 * Math.atan(0.75), LENS.yfov(), 1e-12);
  }
}
