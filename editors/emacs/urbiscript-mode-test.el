;;; urbiscript-mode-test.el --- Tests of urbiscript-mode -*- lexical-binding: t -*-

;;; Commentary:

;; emacs -Q --batch -L editors/emacs -l urbiscript-mode-test -f ert-run-tests-batch-and-exit
;; URBI_KINDS is a folder with texts, and what the scanner of the language says of them.

;;; Code:

(require 'ert)
(require 'urbiscript-mode)

(defmacro urbiscript-test--with (text &rest body)
  "Run BODY in a buffer with TEXT."
  (declare (indent 1))
  `(with-temp-buffer (insert ,text) (urbiscript-mode) (goto-char (point-min)) ,@body))

(defun urbiscript-test--kind (position)
  "What the colours say of the character at POSITION."
  (let ((faces (get-text-property position 'face)))
    (pcase (if (consp faces) (car faces) faces)
      ((or 'font-lock-comment-face 'font-lock-comment-delimiter-face) "comment")
      ('font-lock-string-face "string")
      ('font-lock-keyword-face "keyword")
      ('font-lock-warning-face "refused")
      ('urbiscript-number-face "number")
      (_ "other"))))

(defun urbiscript-test--agree (wanted got)
  "Whether the kind WANTED is shown by the colour GOT."
  (pcase wanted
    ((or "duration" "angle") (equal got "number"))
    ((or "name" "symbol") (equal got "other"))
    ("contextual" (member got '("other" "keyword")))
    ("invalid" t)
    (_ (equal wanted got))))

(defun urbiscript-test--differences (folder number)
  "What the colours of text NUMBER of FOLDER say otherwise, and how many pieces it has."
  (let ((pieces 0) wrong)
    (urbiscript-test--with ""
      (insert-file-contents (expand-file-name (format "%d.u" number) folder))
      (font-lock-ensure)
      (dolist (line (with-temp-buffer
                      (insert-file-contents (expand-file-name (format "%d.kinds" number) folder))
                      (split-string (buffer-string) "\n" t)))
        (pcase-let* ((`(,begin ,end ,kind) (split-string line " "))
                     (begin (1+ (string-to-number begin)))
                     (end (1+ (string-to-number end)))
                     (at begin))
          (setq pieces (1+ pieces))
          (while (and (< at end)
                      (or (memq (char-after at) '(?\s ?\t ?\n))
                          (urbiscript-test--agree kind (urbiscript-test--kind at))))
            (setq at (1+ at)))
          (when (< at end)
            (push (format "%S is %s, here %s" (buffer-substring-no-properties begin end)
                          kind (urbiscript-test--kind at))
                  wrong)))))
    (cons pieces (nreverse wrong))))

(ert-deftest urbiscript-colours-are-those-of-the-scanner ()
  (let ((folder (getenv "URBI_KINDS")) (pieces 0) (number 0) wrong)
    (should folder)
    (dolist (name (with-temp-buffer
                    (insert-file-contents (expand-file-name "names" folder))
                    (split-string (buffer-string) "\n" t)))
      (let ((found (urbiscript-test--differences folder number)))
        (setq pieces (+ pieces (car found))
              number (1+ number))
        (dolist (each (cdr found)) (push (concat name ": " each) wrong))))
    (message "Emacs mode: %d pieces, %d told otherwise" pieces (length wrong))
    (should (> pieces 1000))
    (should-not (reverse wrong))))

(defun urbiscript-test--indented (text)
  "TEXT, indented anew from no indentation at all."
  (urbiscript-test--with (replace-regexp-in-string "^[ \t]+" "" text)
    (indent-region (point-min) (point-max))
    (buffer-string)))

(ert-deftest urbiscript-indents-by-brackets ()
  (dolist (text '("function f(x) {\n  if (x) {\n    echo(x);\n  }\n  else\n  {\n    1;\n  };\n};\n"
                  "var l = [1,\n         2];\n"
                  "var d = [\n  \"a\" => 1,\n];\n"
                  "at (e?(var x)) {\n  echo(\"}\");\n} onleave {\n  echo('{'); // {\n};\necho(1);\n"))
    (should (equal text (urbiscript-test--indented text)))))

(ert-deftest urbiscript-leaves-strings-alone ()
  (urbiscript-test--with "f(\"a\n   b\");\n"
    (indent-region (point-min) (point-max))
    (should (equal "f(\"a\n   b\");\n" (buffer-string)))))

(ert-deftest urbiscript-comments-out-and-in ()
  (urbiscript-test--with "echo(1);\necho(2);\n"
    (comment-region (point-min) (point-max))
    (should (equal "// echo(1);\n// echo(2);\n" (buffer-string)))
    (uncomment-region (point-min) (point-max))
    (should (equal "echo(1);\necho(2);\n" (buffer-string)))))

(ert-deftest urbiscript-stands-a-quote-that-is-never-closed ()
  (urbiscript-test--with (concat "if (x) 'a\n" (apply #'concat (make-list 2000 "var x'd; // x\n")))
    (font-lock-ensure)
    (should (equal '("keyword" "other") (mapcar #'urbiscript-test--kind '(1 9))))
    (goto-char (point-max))
    (forward-line -1)
    (should (equal '("keyword" "other" "comment")
                   (mapcar (lambda (at) (urbiscript-test--kind (+ (point) at))) '(0 4 9))))))

(ert-deftest urbiscript-finds-functions-and-classes ()
  (urbiscript-test--with "class A {\n  function b(x) {};\n};\nfunction c.d() {};\n"
    (let ((index (imenu--make-index-alist t)))
      (should (equal '("b" "c.d") (mapcar #'car (cdr (assoc "Functions" index)))))
      (should (equal '("A") (mapcar #'car (cdr (assoc "Classes" index))))))))

(provide 'urbiscript-mode-test)
;;; urbiscript-mode-test.el ends here
