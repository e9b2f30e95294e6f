package org.urbi.server.tools;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.RenderingHints;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.urbi.server.options.Failure;
import urbi.UImage;

/** A window that shows a sequence of images. */
final class ImageWindow extends JComponent implements AutoCloseable {
  private static final long serialVersionUID = 1L;

  private final JFrame frame;
  private final double scale;
  private transient @Nullable BufferedImage image;
  private volatile boolean open = true;

  private ImageWindow(String title, double scale) {
    this.scale = scale;
    frame = new JFrame(title);
    frame.setContentPane(this);
    frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent event) {
            open = false;
          }
        });
  }

  /**
   * Makes a window, which appears with its first image.
   *
   * @param scale how much larger than the image it is
   * @throws Failure where there is no display
   */
  static ImageWindow open(String title, double scale) {
    try {
      if (!GraphicsEnvironment.isHeadless()) {
        return new ImageWindow(title, scale);
      }
    } catch (HeadlessException | LinkageError e) {
      // An unusable display counts as missing.
    }
    throw Failure.of("no display to show images on: --output=FILE saves one instead");
  }

  /** Whether the user has not closed the window. */
  boolean isOpen() {
    return open;
  }

  /** Shows an image of red, green and blue; the first one gives the window its size. */
  void show(UImage rgb) {
    BufferedImage next =
        new BufferedImage(rgb.getWidth(), rgb.getHeight(), BufferedImage.TYPE_3BYTE_BGR);
    // Elements are given as red, green, blue, however the picture keeps them.
    next.getRaster().setDataElements(0, 0, rgb.getWidth(), rgb.getHeight(), rgb.getData());
    SwingUtilities.invokeLater(() -> take(next));
  }

  private void take(BufferedImage next) {
    boolean first = image == null;
    image = next;
    if (first) {
      setPreferredSize(
          new Dimension((int) (scale * next.getWidth()), (int) (scale * next.getHeight())));
      frame.pack();
      frame.setVisible(true);
    }
    repaint();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    Graphics2D pen = (Graphics2D) graphics;
    pen.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    pen.drawImage(image, 0, 0, getWidth(), getHeight(), null);
  }

  @Override
  public void close() {
    SwingUtilities.invokeLater(frame::dispose);
  }
}
