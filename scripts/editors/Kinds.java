import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.urbi.lang.highlight.Kind;
import org.urbi.lang.highlight.Piece;
import org.urbi.lang.highlight.Pieces;

/**
 * Writes what the scanner of the language says of each file, for editors to be compared with it: {@code N.u}, the
 * input without the kernel's answers, and {@code N.kinds}, a line {@code begin end kind} for each piece.
 *
 * <p>Arguments: the folder for them, and the files, whose listings are taken when they are pages.
 */
final class Kinds {
  private static final Pattern ANSWER = Pattern.compile("(?m)^\\[(\\d{8,}|)(:\\w*)?\\].*\\R?");
  private static final Pattern LISTING = Pattern.compile("(?ms)^( *)```urbiscript\\R(.*?)^\\1```$");
  // Whose extent is a number within it, which no editor counts.
  private static final Pattern COUNTED = Pattern.compile("\\\\B\\(|(?s).*[\\x{10000}-\\x{10FFFF}]");

  private Kinds() {}

  public static void main(String[] args) throws IOException {
    Path folder = Path.of(args[0]);
    List<String> names = new ArrayList<>();
    for (String file : List.of(args).subList(1, args.length)) {
      String text = ANSWER.matcher(input(file)).replaceAll("");
      List<Piece> pieces = Pieces.of(text);
      if (COUNTED.matcher(text).find() || pieces.stream().anyMatch(each -> each.kind() == Kind.BINARY)) {
        continue;
      }
      Path kinds = folder.resolve(names.size() + ".kinds");
      Files.writeString(folder.resolve(names.size() + ".u"), text);
      Files.writeString(kinds, pieces.stream().map(Kinds::line).collect(Collectors.joining()));
      names.add(file);
    }
    Files.write(folder.resolve("names"), names);
  }

  private static String input(String file) throws IOException {
    String text = Files.readString(Path.of(file)).replace("\r\n", "\n");
    if (!file.endsWith(".md")) {
      return text;
    }
    StringBuilder listings = new StringBuilder();
    for (Matcher each = LISTING.matcher(text); each.find(); ) {
      listings.append(each.group(2));
    }
    return listings.toString();
  }

  private static String line(Piece piece) {
    return piece.begin() + " " + piece.end() + " " + piece.kind().toString().toLowerCase(Locale.ROOT) + "\n";
  }
}
