;;; urbiscript-mode.el --- Major mode for urbiscript -*- lexical-binding: t -*-

;; Copyright (c) 2026, the Urbi on the JVM authors
;; SPDX-License-Identifier: BSD-3-Clause
;; Version: 3.0.0
;; Package-Requires: ((emacs "26.1"))
;; Keywords: languages

;;; Commentary:

;; Colours, indentation and comments for programs in urbiscript (*.u).  Lines that begin with a
;; time stamp are what a kernel has answered, in sessions (*.u-session).

;;; Code:

(require 'imenu)

(defgroup urbiscript nil
  "Programs in urbiscript."
  :group 'languages)

(defcustom urbiscript-indent-offset 2
  "By how many columns code in brackets is indented."
  :type 'integer
  :safe #'integerp
  :group 'urbiscript)

(defface urbiscript-number-face
  '((t :inherit font-lock-constant-face))
  "Numbers, durations and angles."
  :group 'urbiscript)

(defface urbiscript-answer-face
  '((t :inherit shadow))
  "What a kernel has answered."
  :group 'urbiscript)

(defconst urbiscript-keywords
  '("and" "and_eq" "assert" "at" "bitand" "bitor" "break" "call" "case" "catch" "class" "closure"
    "compl" "const" "continue" "default" "do" "else" "emit" "enum" "every" "external" "finally"
    "for" "foreach" "freezeif" "function" "if" "in" "loop" "loopn" "not" "not_eq" "onleave" "or"
    "or_eq" "return" "stopif" "switch" "this" "throw" "timeout" "try" "var" "waituntil" "watch"
    "whenever" "while" "xor" "xor_eq")
  "Words that mean something wherever they stand.")

(defconst urbiscript-contextual
  '("get" "import" "new" "package" "set")
  "Words that name slots as well, after a point above all.")

(defconst urbiscript-refused
  '("asm" "auto" "bool" "char" "const_cast" "delete" "double" "dynamic_cast" "explicit" "export"
    "extern" "float" "friend" "goto" "inline" "int" "internal" "long" "mutable" "namespace"
    "private" "protected" "public" "register" "reinterpret_cast" "short" "signed" "sizeof"
    "static" "static_cast" "struct" "template" "typedef" "typeid" "typename" "union" "unsigned"
    "using" "virtual" "volatile" "wchar_t")
  "Words that may not be used, or that have no effect.")

(defconst urbiscript-constants
  '("acceptVoid" "false" "inf" "nan" "nil" "true" "void")
  "Names of values that every program knows.")

(defvar urbiscript-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?_ "w" table)
    (modify-syntax-entry ?/ ". 124b" table)
    (modify-syntax-entry ?* ". 23n" table)
    (modify-syntax-entry ?\n "> b" table)
    (modify-syntax-entry ?\" "\"" table)
    (modify-syntax-entry ?\\ "\\" table)
    (modify-syntax-entry ?' "." table)
    (dolist (operator '(?+ ?- ?= ?% ?< ?> ?& ?| ?^ ?! ?~ ?? ?: ?\; ?, ?.))
      (modify-syntax-entry operator "." table))
    table)
  "Syntax table of `urbiscript-mode'.")

(defun urbiscript--after-name-p (position)
  "Whether a name ends at POSITION: a quote there is a part of it, as in x\='d."
  (save-excursion
    (goto-char position)
    (and (/= 0 (skip-chars-backward "a-zA-Z0-9_"))
         (looking-at "[a-zA-Z_]")
         (not (looking-at (concat (regexp-opt urbiscript-keywords) "'"))))))

(defun urbiscript--mark-name (begin)
  "Mark the quoted name that begins at BEGIN, if it ends anywhere, and go there."
  (goto-char (1+ begin))
  (while (progn (skip-chars-forward "^'\\\\") (eq (char-after) ?\\))
    (forward-char (min 2 (- (point-max) (point)))))
  (if (eobp)
      (goto-char (1+ begin))
    (put-text-property begin (1+ begin) 'syntax-table (string-to-syntax "|"))
    (put-text-property (point) (1+ (point)) 'syntax-table (string-to-syntax "|"))
    (forward-char)))

(defun urbiscript--propertize (begin end)
  "Find quoted names between BEGIN and END."
  (let ((state (syntax-ppss begin)))
    (if (eq (nth 3 state) t) (urbiscript--mark-name (nth 8 state)) (goto-char begin)))
  (while (and (< (point) end) (search-forward "'" end t))
    (let ((quote (match-beginning 0)))
      (cond ((nth 8 (save-excursion (syntax-ppss quote))))
            ;; The second quote of y\='\=' begins nothing.
            ((urbiscript--after-name-p quote) (when (eq (char-after) ?') (forward-char)))
            (t (urbiscript--mark-name quote))))))

(defun urbiscript--syntactic-face (state)
  "The face of the string or comment of STATE: quoted names are names."
  (cond ((nth 4 state) 'font-lock-comment-face)
        ((eq (nth 3 state) t) 'font-lock-variable-name-face)
        (t 'font-lock-string-face)))

(defconst urbiscript--name "[a-zA-Z_][a-zA-Z0-9_]*")

(defconst urbiscript-font-lock-keywords
  `(("^\\[\\(?:[0-9]\\{8,\\}\\|\\)\\(?::[a-z]*\\)?\\].*$" 0 'urbiscript-answer-face t)
    ;; But not what is derived from a name: x'in.
    (,(regexp-opt urbiscript-keywords 'words)
     (1 (unless (eq (char-before (match-beginning 1)) ?') font-lock-keyword-face)))
    (,(concat (regexp-opt urbiscript-contextual 'words) "[ \t]+['a-zA-Z_]")
     (1 (unless (eq (char-before (match-beginning 1)) ?.) font-lock-keyword-face)))
    (,(regexp-opt urbiscript-refused 'words) . font-lock-warning-face)
    (,(concat "\\_<function[ \t]+\\(?:" urbiscript--name "\\.\\)*\\(" urbiscript--name "\\)")
     1 font-lock-function-name-face)
    (,(concat "\\_<\\(?:class\\|enum\\|package\\)[ \t]+\\(?:" urbiscript--name "\\.\\)*\\(" urbiscript--name "\\)")
     1 font-lock-type-face)
    (,(regexp-opt urbiscript-constants 'words)
     (1 (unless (eq (char-before (match-beginning 1)) ?.) font-lock-constant-face)))
    ("\\_<[A-Z][a-zA-Z0-9_]*" . font-lock-type-face)
    ("\\_<\\(?:0[xX][0-9a-zA-Z_]+\\|[0-9][0-9_]*\\(?:\\.[0-9][0-9_]*\\)?\\(?:[eE][-+]?[0-9][0-9_]*\\)?[a-zA-Z_0-9]*\\)"
     . 'urbiscript-number-face))
  "What is coloured beside comments, strings and quoted names.")

(defun urbiscript--indentation ()
  "The column of the code of this line, or nil where it is to be left alone."
  (save-excursion
    (back-to-indentation)
    (let* ((state (syntax-ppss))
           (opener (nth 1 state))
           (closing (looking-at-p "[])}]")))
      (cond ((nth 3 state) nil)
            ((nth 4 state) (urbiscript--comment-indentation state))
            ((null opener) 0)
            (t (goto-char opener)
               ;; Arguments are below the first one, if that is in the line of the bracket.
               (if (and (not closing) (memq (char-after) '(?\( ?\[))
                        (save-excursion (forward-char) (skip-chars-forward " \t") (not (eolp))))
                   (progn (forward-char) (skip-chars-forward " \t") (current-column))
                 (+ (current-indentation) (if closing 0 urbiscript-indent-offset))))))))

(defun urbiscript--comment-indentation (state)
  "The column of a line in the comment of STATE: that of the line before it."
  (if (looking-at-p "\\*")
      (save-excursion (goto-char (nth 8 state)) (1+ (current-column)))
    (forward-line -1)
    (if (<= (line-beginning-position) (nth 8 state))
        (save-excursion (goto-char (nth 8 state)) (+ 3 (current-column)))
      (current-indentation))))

(defun urbiscript-indent-line ()
  "Indent this line by the brackets around it."
  (interactive)
  (let ((column (urbiscript--indentation)))
    (if (null column)
        'noindent
      (if (<= (current-column) (current-indentation))
          (indent-line-to column)
        (save-excursion (indent-line-to column))))))

(defvar urbiscript--imenu
  `(("Functions" ,(concat "^[ \t]*function[ \t]+\\([a-zA-Z0-9_.]+\\)") 1)
    ("Classes" ,(concat "^[ \t]*class[ \t]+\\([a-zA-Z0-9_.]+\\)") 1))
  "What the index of a program has.")

;;;###autoload
(define-derived-mode urbiscript-mode prog-mode "urbiscript"
  "Major mode for programs in urbiscript.

\\{urbiscript-mode-map}"
  (setq-local comment-start "// ")
  (setq-local comment-end "")
  (setq-local comment-start-skip "\\(?://+\\|/\\*+\\)[ \t]*")
  (setq-local parse-sexp-lookup-properties t)
  (setq-local syntax-propertize-function #'urbiscript--propertize)
  (setq-local font-lock-defaults
              '(urbiscript-font-lock-keywords nil nil nil
                (font-lock-syntactic-face-function . urbiscript--syntactic-face)))
  (setq-local indent-line-function #'urbiscript-indent-line)
  (setq-local indent-tabs-mode nil)
  (setq-local electric-indent-chars (append "{}()[]" electric-indent-chars))
  (setq-local imenu-generic-expression urbiscript--imenu))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.u\\(?:-session\\)?\\'" . urbiscript-mode))

(provide 'urbiscript-mode)
;;; urbiscript-mode.el ends here
