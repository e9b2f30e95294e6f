package urbi;

import java.awt.Component;
import java.awt.Container;
import java.awt.Frame;
import java.awt.Graphics;
import java.awt.Image;
import java.awt.MediaTracker;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import org.jspecify.annotations.Nullable;
import urbi.media.ImageFiles;

/** Helper methods for programs that show images in windows. */
public final class ImageUtilities {
  private static volatile int width;
  private static volatile int height;

  private ImageUtilities() {}

  /** Sets the width that images are made by {@link #makeBufferedImage}; 0 for their own. */
  public static void setWidth(int pixels) {
    width = pixels;
  }

  /** Sets the height that images are made by {@link #makeBufferedImage}; 0 for their own. */
  public static void setHeight(int pixels) {
    height = pixels;
  }

  public static int getWidth() {
    return width;
  }

  public static int getHeight() {
    return height;
  }

  /** Waits until an image is there; whether it is. */
  public static boolean waitForImage(Image image) {
    MediaTracker tracker = new MediaTracker(new Container());
    tracker.addImage(image, 0);
    try {
      tracker.waitForAll();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
    return !tracker.isErrorAny();
  }

  /** The image of a file: JPEG, PNG, GIF. */
  public static Image blockingLoad(byte[] file) {
    return ImageFiles.read(file);
  }

  /** The image in memory, as red, green and blue; null if it cannot be had. */
  public static @Nullable BufferedImage makeBufferedImage(Image image) {
    return makeBufferedImage(image, BufferedImage.TYPE_INT_RGB);
  }

  /**
   * The image in memory; null if it cannot be had.
   *
   * @param type as {@link BufferedImage#BufferedImage(int, int, int)} has it
   */
  public static @Nullable BufferedImage makeBufferedImage(Image image, int type) {
    if (!waitForImage(image)) {
      return null;
    }
    int wide = width == 0 ? image.getWidth(null) : width;
    int high = height == 0 ? image.getHeight(null) : height;
    BufferedImage made = new BufferedImage(wide, high, type);
    Graphics graphics = made.getGraphics();
    graphics.drawImage(image, 0, 0, wide, high, null);
    graphics.dispose();
    return made;
  }

  /** A window around a component, which is not cleared when it is drawn again. */
  public static Frame getNonClearingFrame(String title, Component component) {
    Frame frame =
        new Frame(title) {
          private static final long serialVersionUID = 1;

          @Override
          public void update(Graphics graphics) {
            paint(graphics);
          }
        };
    frame.add(component);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            frame.dispose();
          }
        });
    sizeContainerToComponent(frame, component);
    centerFrame(frame);
    return frame;
  }

  /** Gives a window the size that what is in it wants. */
  public static void sizeContainerToComponent(Container container, Component component) {
    container.setSize(component.getPreferredSize());
  }

  /** Puts a window into the middle of the screen. */
  public static void centerFrame(Frame frame) {
    frame.setLocationRelativeTo(null);
  }
}
