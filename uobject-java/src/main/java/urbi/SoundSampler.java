package urbi;

import java.awt.FileDialog;
import java.awt.FlowLayout;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JFrame;
import org.jspecify.annotations.Nullable;
import urbi.thread.GuardedThreads;

/** A window with buttons to record a sound, to play it, and to save it. */
@SuppressWarnings("this-escape") // It shows itself as soon as it is constructed.
public class SoundSampler extends JFrame {
  private static final long serialVersionUID = 1;

  private final JButton capture = new JButton("Capture");
  private final JButton stop = new JButton("Stop");
  private final JButton play = new JButton("Play");
  private final JButton save = new JButton("Save");
  private transient volatile @Nullable SoundAction action;

  /** Shows the window. */
  public SoundSampler() {
    super("Sound sampler");
    setDefaultCloseOperation(EXIT_ON_CLOSE);
    setLayout(new FlowLayout());
    capture.addActionListener(event -> {
      recording(true);
      run(SoundAction::captureAudio);
    });
    stop.addActionListener(event -> {
      recording(false);
      SoundAction present = action;
      if (present != null) {
        present.stopAudio();
      }
    });
    play.addActionListener(event -> run(SoundAction::playAudio));
    save.addActionListener(event -> save());
    add(capture);
    add(stop);
    add(play);
    add(save);
    stop.setEnabled(false);
    play.setEnabled(false);
    save.setEnabled(false);
    pack();
    setVisible(true);
  }

  /** Says what the buttons do. */
  public void setAction(SoundAction other) {
    action = other;
  }

  private void recording(boolean now) {
    capture.setEnabled(!now);
    stop.setEnabled(now);
    play.setEnabled(!now);
    save.setEnabled(!now);
  }

  private void save() {
    FileDialog dialog = new FileDialog(this, "Save the sound", FileDialog.SAVE);
    dialog.setVisible(true);
    if (dialog.getFile() != null) {
      String path = dialog.getDirectory() + dialog.getFile();
      run(present -> present.saveAudio(path));
    }
  }

  private void run(Consumer<SoundAction> task) {
    SoundAction present = action;
    if (present != null) {
      GuardedThreads.SDK.platform("urbi-sound", () -> task.accept(present)).start();
    }
  }
}
