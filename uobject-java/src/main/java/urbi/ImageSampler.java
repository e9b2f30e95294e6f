package urbi;

import static java.util.Objects.requireNonNull;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Label;
import java.awt.List;
import java.awt.color.ColorSpace;
import java.awt.event.ItemEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.AffineTransformOp;
import java.awt.image.BufferedImage;
import java.awt.image.BufferedImageOp;
import java.awt.image.ColorConvertOp;
import java.awt.image.ConvolveOp;
import java.awt.image.Kernel;
import java.awt.image.RescaleOp;
import java.util.Map;
import java.util.TreeMap;
import javax.swing.JFrame;
import urbi.media.ImageFiles;

/**
 * A window with the images that come, and one with a list of effects: the one that is chosen is
 * applied to the image that is there. The program ends when the list is closed.
 */
@SuppressWarnings("this-escape") // It shows itself as soon as it is constructed.
public class ImageSampler extends Frame {
  private static final long serialVersionUID = 1;
  private static final float NINTH = 1 / 9f;

  private final transient Map<String, BufferedImageOp> effects = effects();
  private final Label status = new Label("");
  private final ImageComponent original = new ImageComponent();
  private final ImageComponent changed = new ImageComponent();
  private final JFrame originalWindow = new JFrame("Image");
  private final JFrame changedWindow = new JFrame("Changed image");

  /** Shows both windows. */
  public ImageSampler() {
    super("Image sampler");
    List names = new List();
    effects.keySet().forEach(names::add);
    names.addItemListener(event -> {
      if (event.getStateChange() == ItemEvent.SELECTED) {
        apply(names.getSelectedItem());
      }
    });
    add(names, BorderLayout.CENTER);
    add(status, BorderLayout.SOUTH);
    addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            originalWindow.dispose();
            changedWindow.dispose();
            dispose();
            System.exit(0);
          }
        });
    originalWindow.add(original);
    changedWindow.add(changed);
    setSize(200, 350);
    setVisible(true);
  }

  private static Map<String, BufferedImageOp> effects() {
    Map<String, BufferedImageOp> effects = new TreeMap<>();
    effects.put("Blur", kernel(NINTH, NINTH, NINTH, NINTH, NINTH, NINTH, NINTH, NINTH, NINTH));
    effects.put("Sharpen", kernel(0, -1, 0, -1, 5, -1, 0, -1, 0));
    effects.put("Edges", kernel(0, -1, 0, -1, 4, -1, 0, -1, 0));
    effects.put("Brighter", new RescaleOp(1.5f, 0, null));
    effects.put("Darker", new RescaleOp(0.5f, 0, null));
    effects.put("Negative", new RescaleOp(-1, 255, null));
    effects.put("Grey", new ColorConvertOp(ColorSpace.getInstance(ColorSpace.CS_GRAY), null));
    effects.put(
        "Half the size",
        new AffineTransformOp(
            AffineTransform.getScaleInstance(0.5, 0.5), AffineTransformOp.TYPE_BILINEAR));
    return effects;
  }

  private static ConvolveOp kernel(float... weights) {
    return new ConvolveOp(new Kernel(3, 3, weights), ConvolveOp.EDGE_NO_OP, null);
  }

  private void apply(String effect) {
    BufferedImage image = original.getImage();
    if (image != null) {
      BufferedImage rgb = ImageUtilities.makeBufferedImage(image);
      BufferedImageOp chosen = requireNonNull(effects.get(effect), "it was chosen from the list");
      changed.setImage(chosen.filter(rgb, null));
      changedWindow.pack();
      changedWindow.setVisible(true);
      status.setText(effect + ": done");
    }
  }

  /** Shows a file: JPEG, PNG, GIF. */
  public void addImage(byte[] file, int width, int height) {
    addImage(ImageFiles.read(file), width, height);
  }

  /** Shows a file, and a cross at a place of it. */
  public void addImage(byte[] file, int width, int height, double x, double y) {
    addImage(ImageFiles.read(file), width, height, x, y);
  }

  public void addImage(BufferedImage image, int width, int height) {
    addImage(image, width, height, -1, -1);
  }

  /** Shows an image, and a cross at a place of it. */
  public void addImage(BufferedImage image, int width, int height, double x, double y) {
    EventQueue.invokeLater(() -> {
      boolean resized = original.getWidth() != width || original.getHeight() != height;
      original.setWidth(width);
      original.setHeight(height);
      original.setImage(image, x, y);
      if (resized || !originalWindow.isVisible()) {
        originalWindow.pack();
        originalWindow.setVisible(true);
      }
    });
  }
}
