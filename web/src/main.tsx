document.title = 'bouncelab';
