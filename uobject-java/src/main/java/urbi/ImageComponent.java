package urbi;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import org.jspecify.annotations.Nullable;
import urbi.media.ImageFiles;

/** Shows an image in a window, with a cross at a place that matters. */
public class ImageComponent extends JPanel {
  private static final long serialVersionUID = 1;
  private static final int ARM = 5;

  private transient @Nullable BufferedImage image;
  private int wantedWidth;
  private int wantedHeight;
  private double markX = -1;
  private double markY = -1;

  /** How wide the image is shown, in pixels; 0 for its own width. */
  public void setWidth(int pixels) {
    wantedWidth = pixels;
  }

  /** How high the image is shown, in pixels; 0 for its own height. */
  public void setHeight(int pixels) {
    wantedHeight = pixels;
  }

  @Override
  public int getWidth() {
    return wantedWidth == 0 ? super.getWidth() : wantedWidth;
  }

  @Override
  public int getHeight() {
    return wantedHeight == 0 ? super.getHeight() : wantedHeight;
  }

  /** Shows a file: JPEG, PNG, GIF. */
  public void setImage(byte[] file) {
    setImage(ImageFiles.read(file));
  }

  /** Shows a file, and a cross. */
  public void setImage(byte[] file, double x, double y) {
    setImage(ImageFiles.read(file), x, y);
  }

  public void setImage(BufferedImage other) {
    setImage(other, -1, -1);
  }

  /** Shows an image, and a cross at a place of it; none where that is negative. */
  public void setImage(BufferedImage other, double x, double y) {
    image = other;
    markX = x;
    markY = y;
    repaint();
  }

  public @Nullable BufferedImage getImage() {
    return image;
  }

  @Override
  public Dimension getPreferredSize() {
    if (image == null) {
      return new Dimension(wantedWidth, wantedHeight);
    }
    return new Dimension(
        wantedWidth == 0 ? image.getWidth() : wantedWidth,
        wantedHeight == 0 ? image.getHeight() : wantedHeight);
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    BufferedImage shown = image;
    if (shown == null) {
      return;
    }
    Dimension size = getPreferredSize();
    graphics.drawImage(shown, 0, 0, size.width, size.height, this);
    if (markX >= 0 && markY >= 0) {
      int x = (int) (markX * size.width / shown.getWidth());
      int y = (int) (markY * size.height / shown.getHeight());
      graphics.setColor(Color.RED);
      graphics.drawLine(x - ARM, y, x + ARM, y);
      graphics.drawLine(x, y - ARM, x, y + ARM);
    }
  }
}
