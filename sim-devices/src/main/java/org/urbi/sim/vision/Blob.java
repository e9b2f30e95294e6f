package org.urbi.sim.vision;

/**
 * A patch of one colour in an image, as the interface BlobDetector has it.
 *
 * @param x of its centre: from -0.5 at the left edge to 0.5 at the right one
 * @param y of its centre: from -0.5 at the lower edge to 0.5 at the upper one
 * @param ratio its share of the image, from 0 to 1
 * @param elongation its greater diameter divided by its smaller one
 * @param orientation of its greater diameter, in radians; 0 is horizontal
 * @param radius of the circle of the same area, in pixels
 */
public record Blob(
    double x, double y, double ratio, double elongation, double orientation, double radius) {}
