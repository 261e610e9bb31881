document.addEventListener("DOMContentLoaded", function () {
    if (document.querySelector(".math")) {
        renderMathInElement(document.body, {
            delimiters: [
                {left: "\\[", right: "\\]", display: true},
                {left: "\\(", right: "\\)", display: false},
            ],
        });
    }
});
