package org.urbi.server.trust;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermission;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;

/** The tokens that a server accepts; a client authenticates with one. */
public final class Tokens {
  /** The minimum length of a token; shorter ones can be guessed. */
  static final int MIN_LENGTH = 16;

  private static final String HASHED = "sha256:";
  private static final Set<PosixFilePermission> OTHERS =
      EnumSet.of(
          PosixFilePermission.GROUP_READ,
          PosixFilePermission.GROUP_WRITE,
          PosixFilePermission.OTHERS_READ,
          PosixFilePermission.OTHERS_WRITE);

  /**
   * The holder of a token.
   *
   * @param name for people
   */
  public record TokenHolder(Role role, String name) {}

  private record KnownToken(byte[] hash, TokenHolder holder) {}

  private final List<KnownToken> known = new ArrayList<>();

  private Tokens() {}

  /**
   * Reads a file of tokens: on each line a role, a token or {@code sha256:} and its hash in
   * hexadecimal digits, a name for people. Empty lines, and those that begin with #, are passed
   * over.
   *
   * @throws IOException if it cannot be read, makes no sense, or others can read it; the message
   *     says what is wrong, without a token
   */
  public static Tokens read(Path file) throws IOException {
    PosixFileAttributeView posix =
        Files.getFileAttributeView(file, PosixFileAttributeView.class, new LinkOption[0]);
    if (posix != null && posix.readAttributes().permissions().stream().anyMatch(OTHERS::contains)) {
      throw new IOException(file + " can be read or written by others: chmod 600 " + file);
    }
    Tokens tokens = new Tokens();
    int number = 0;
    for (String line : Files.readAllLines(file, StandardCharsets.UTF_8)) {
      number++;
      if (!line.isBlank() && !line.startsWith("#")) {
        try {
          tokens.add(line.strip().split("\\s+", 3));
        } catch (IllegalArgumentException e) {
          throw new IOException(file + ", line " + number + ": " + e.getMessage(), e);
        }
      }
    }
    if (tokens.known.isEmpty()) {
      throw new IOException(file + " has no tokens");
    }
    return tokens;
  }

  /** One token alone. */
  public static Tokens single(String token, Role role, String name) {
    Tokens tokens = new Tokens();
    tokens.known.add(new KnownToken(hash(token), new TokenHolder(role, name)));
    return tokens;
  }

  private void add(String[] words) {
    Role role = Role.of(words[0]);
    if (role == null) {
      throw new IllegalArgumentException("the role must be owner, user or observer");
    }
    if (words.length < 2) {
      throw new IllegalArgumentException("the token is missing");
    }
    TokenHolder holder = new TokenHolder(role, words.length < 3 ? role.text() : words[2]);
    known.add(new KnownToken(stored(words[1]), holder));
  }

  private static byte[] stored(String word) {
    if (!word.startsWith(HASHED)) {
      if (word.length() < MIN_LENGTH) {
        throw new IllegalArgumentException(
            "a token has " + MIN_LENGTH + " characters at least: others can be guessed");
      }
      return hash(word);
    }
    byte[] hash = HexFormat.of().parseHex(word.substring(HASHED.length()));
    if (hash.length != hash("").length) {
      throw new IllegalArgumentException("the hash has not the length of SHA-256");
    }
    return hash;
  }

  /** The SHA-256 of a token, in hexadecimal digits. */
  static String digest(String token) {
    return HexFormat.of().formatHex(hash(token));
  }

  private static byte[] hash(String token) {
    try {
      return MessageDigest.getInstance("SHA-256").digest(token.getBytes(StandardCharsets.UTF_8));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The holder of that token; null if it is unknown. The time that this takes reveals nothing about
   * the tokens.
   */
  public @Nullable TokenHolder holder(String token) {
    byte[] hash = hash(token);
    TokenHolder found = null;
    for (KnownToken each : known) {
      if (MessageDigest.isEqual(each.hash, hash)) {
        found = each.holder;
      }
    }
    return found;
  }
}
